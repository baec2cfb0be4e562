#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "shell/shell_survey.h"
#include "stations/stations.h"
#include "support/made_clouds.h"

/// Shells whose radius at every azimuth and height is given by a formula, with the tank and stations that belong to
/// them.
namespace tank_datum::made_shells {

using made_clouds::kTurn;
using made_clouds::uniform;

inline constexpr double kRadius = 10.0;
inline constexpr double kFoot = 2.0;  ///< elevation of the datum [m]
inline const Eigen::Vector2d kCentre(3.0, -4.0);

inline Tank tank10() {
  Tank tank;
  tank.circle = {kCentre, kRadius};
  tank.foot.coefficients = Eigen::Vector3d(kFoot, 0.0, 0.0);
  return tank;
}

inline std::vector<Station> stations(const StationOptions& options = {}) {
  std::vector<Station> all = emptyStations(options);
  for (Station& s : all) s.z = kFoot, s.flag = StationFlag::Measured;
  return all;
}

struct MadeShell {
  std::function<double(double, double)> radius = [](double, double) { return kRadius; };  ///< by azimuth and height
  std::function<bool(double, double)> seen = [](double, double) { return true; };
  double noise = 0.0;
  double from = 0.0, to = 4.5;  ///< heights [m]
  int count = 400'000;
  std::uint64_t seed = 1;

  Points points() const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Points all;
    for (int i = 0; i < count; ++i) {
      const double a = kTurn * uniform(random), h = from + (to - from) * uniform(random), off = normal(random);
      if (!seen(a, h)) continue;
      const double r = radius(a, h) + noise * off;
      all.emplace_back(kCentre.x() + r * std::cos(a), kCentre.y() + r * std::sin(a), kFoot + h);
    }
    return all;
  }
};

/// Heights of 0.3, 1.3, 2.3 m and so on.
inline ShellOptions everyMetre() {
  ShellOptions options;
  options.step = 1.0;
  return options;
}

inline ShellBands bandsOf(const Points& points, const ShellOptions& options = everyMetre()) {
  ShellBands bands(tank10(), options);
  bands.gather(0, points);
  return bands;
}

inline ShellSurvey surveyOf(const Points& points, const ShellOptions& options = everyMetre(),
                            const StationOptions& around = {}) {
  return surveyShell(bandsOf(points, options), stations(around), tank10().circle, options, around);
}

inline double degrees(double radians) { return radians * 360.0 / kTurn; }

}  // namespace tank_datum::made_shells
