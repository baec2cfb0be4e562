#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "movement/epoch_matching.h"

namespace tank_datum::made_differences {

/// Differences of 1 mm sigma whose errors are means of white noise over `shared` stations.
inline std::vector<MatchedStation> differences(std::size_t count, std::size_t shared, unsigned seed,
                                               double errors = 0.001) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> white(count);
  for (double& w : white) w = normal(generator);
  std::vector<MatchedStation> stations(count);
  for (std::size_t i = 0; i < count; ++i) {
    MatchedStation& m = stations[i];
    m.direction = kTwoPi * static_cast<double>(i) / static_cast<double>(count);
    m.sigma = 0.001, m.window = 2.0 * kDegree;
    for (std::size_t k = 0; k < shared; ++k) m.dz += white[(i + k) % count];
    m.dz *= errors / std::sqrt(static_cast<double>(shared));
  }
  return stations;
}

}  // namespace tank_datum::made_differences
