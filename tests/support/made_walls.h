#pragma once

#include <cmath>
#include <vector>

#include "locate/wall_sector.h"

/// Hits of walls put where a test wants them.
namespace tank_datum::made_walls {

inline constexpr double kVoxel = 0.1;
inline constexpr double kThickness = 0.075;

/// A wall from `from` to `to`, `off` outside of the circle, a hit every half voxel.
inline void stack(std::vector<Hit>& hits, double from, double to, double off, double lean = 0.0) {
  const int count = static_cast<int>(std::lround((to - from) / (0.5 * kVoxel)));
  for (int i = 0; i < count; ++i) {
    const double z = from + 0.5 * kVoxel * i;
    hits.push_back({z, off + lean * z});
  }
}

}  // namespace tank_datum::made_walls
