#pragma once

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "core/units.h"
#include "foot/foot_state.h"
#include "support/made_rings.h"

/// Foots of an upright shell of 10 m radius, about the origin and upon z = 0, with points put where a test wants them.
namespace tank_datum::made_feet {

inline constexpr double kRadius = 10.0, kReach = 0.5;
inline constexpr FootScales kScales{0.3, 0.001, 0.013};

class MadeFoot {
 public:
  explicit MadeFoot(int stations = 360) : stations_(stations) {}

  double step() const { return kTwoPi / stations_; }

  /// A point at an azimuth, d outside of the shell.
  void add(double azimuth, double d, double z) {
    points_.emplace_back((kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), z);
  }
  /// So many points on a station's stretch of the foundation, evenly from one distance to another.
  template <typename Height>
  void addStation(int station, int count, double from, double to, const Height& height) {
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count, d = from + (to - from) * share;
      const double beside = 0.9 * (std::fmod(0.618034 * i, 1.0) - 0.5);
      add((station + beside) * step(), d, height(d));
    }
  }
  /// So many points of a station's stretch of the shell, of the part that tells how steeply rays come.
  void addShell(int station, int count) {
    for (int k = 0; k < count; ++k) {
      const double share = (k + 0.5) / count;
      add((station + 0.9 * (share - 0.5)) * step(), 0.0, kReach * (0.1 + 0.4 * share));
    }
  }
  template <typename Height>
  void addAll(int count, double from, double to, const Height& height) {
    for (int s = 0; s < stations_; ++s) addStation(s, count, from, to, height);
  }

  /// The foot as the passes see it, each station's own points among it. Must outlive what is returned.
  Foot& foot(const FootScales& scales = kScales) {
    ShellLine line;
    line.radius = kRadius;
    line.points = 100;
    line.noise = scales.shell_noise;
    const ShellModel shell(std::vector<ShellLine>(360, line), 0.0);
    foot_.emplace(Foot{FootRing(PolarRing(points_, {0.0, 0.0}), shell, 1.0, kReach),
                       options,
                       scales,
                       kReach,
                       0.5 * step(),
                       kRadius,
                       0.0,
                       {},
                       {},
                       {}});
    for (int s = 0; s < stations_; ++s) {
      foot_->directions.push_back(s * step());
      foot_->points.push_back(foot_->ring.around(foot_->directions.back(), foot_->half_step, 0.0, kReach));
      foot_->shell_seen.push_back(true);
    }
    return *foot_;
  }

  RefineOptions options;

 private:
  int stations_;
  Points points_;
  std::optional<Foot> foot_;
};

inline Tank tankOfFoot() { return made_rings::levelTank(kRadius); }

/// What a pass may have found of a level surface, up to `band_to` from the shell.
inline FootPass levelPass(double half_width, double band_to) {
  FootFit fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0;
  fit.sigma = 0.0002, fit.noise = 0.0004, fit.sigma_slope = 0.001, fit.half_width = half_width;
  FootPass pass;
  pass.stood.assign(360, true);
  pass.fits.assign(360, fit);
  pass.priors.slope.assign(360, 0.0);
  pass.priors.sigma_slope.assign(360, 0.01);
  pass.priors.sigma_bend = 0.01;
  pass.sections.stations = 360;
  FootProfile& profile = pass.sections.whole;
  profile.bin = 0.003, profile.band_from = 0.015, profile.noise = 0.0005, profile.blur = 0.004;
  profile.band_to = profile.edge = band_to;
  return pass;
}

}  // namespace tank_datum::made_feet
