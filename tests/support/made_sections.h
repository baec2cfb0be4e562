#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "foot/foot_profile.h"
#include "support/made_clouds.h"

/// Sections of a foot, made of points on a curve.
namespace tank_datum::made_sections {

using made_clouds::uniform;

inline constexpr double kNoise = 0.0005;
inline const FootScales kScales{0.3, 0.0015, 0.013};

/// The foot of 60 stations with an oval datum, by its height above the datum against the distance from the shell.
struct MadeFoot {
  std::vector<std::vector<FootPoint>> stations;
  std::vector<double> datum;

  explicit MadeFoot(const std::function<double(double)>& section, int points = 400, double noise = kNoise) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    for (int s = 0; s < 60; ++s) {
      datum.push_back(5.0 + 0.02 * std::cos(0.2 * s));
      stations.emplace_back();
      for (int i = 0; i < points; ++i) {
        const double d = -0.02 + 0.34 * uniform(random), t = uniform(random) - 0.5;
        stations.back().push_back({t, d, datum.back() + section(d) + noise * normal(random)});
      }
    }
  }
  FootProfile profile(const FootScales& scales = kScales) const { return stackProfile(stations, datum, scales); }
};

}  // namespace tank_datum::made_sections
