#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "foot/narrow_lips.h"
#include "support/made_feet.h"

namespace tank_datum::made_narrow_lips {

using made_feet::MadeFoot;

/// A ringwall upon z = 0 from 30 mm on, two points a millimetre and station, and what lies beside the shell.
struct Scene {
  double from = 0.008, to = 0.026, height = 0.008;              ///< of a lip [m]
  double noise = 0.0003;                                        ///< of the fits [m]
  double shell_noise = 0.001;                                   ///< [m]
  double density = 2000.0;                                      ///< points a station [1/m]
  std::function<bool(int)> has_lip = [](int) { return true; };  ///< at a station
  std::function<bool(int)> stands = [](int) { return true; };
  std::function<void(MadeFoot&)> add = [](MadeFoot&) {};
};

inline std::vector<Lift> lipsOf(const Scene& scene, bool on_plate = false) {
  MadeFoot made;
  made.addAll(static_cast<int>(0.25 * scene.density), 0.03, 0.28, [](double) { return 0.0; });
  std::vector<FootFit> fits(360);
  for (int s = 0; s < 360; ++s) {
    const int points = static_cast<int>(std::lround(scene.density * (scene.to - scene.from)));
    if (scene.has_lip(s)) made.addStation(s, points, scene.from, scene.to, [&](double) { return scene.height; });
    if (!scene.stands(s)) continue;
    FootFit& fit = fits[static_cast<std::size_t>(s)];
    fit.sigma = 0.0002, fit.noise = scene.noise;
    fit.z = fit.slope = fit.along = fit.bend = 0.0;
  }
  scene.add(made);
  FootSections sections;
  sections.whole.band_from = 0.03, sections.whole.band_to = 0.28;
  sections.whole.surface = on_plate ? Surface::AnnularPlate : Surface::Ringwall;
  return findNarrowLips(made.foot({0.3, scene.shell_noise, 0.013}), fits, sections);
}

inline Scene lip(double from, double to, double height = 0.008) {
  Scene scene;
  scene.from = from, scene.to = to, scene.height = height;
  return scene;
}

inline bool isRaised(const Scene& scene) { return lipsOf(scene)[100].height > 0.0; }

}  // namespace tank_datum::made_narrow_lips
