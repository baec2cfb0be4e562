#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tank_datum {

/// The number of the cell of a grid that a coordinate in cells lies in. What lies beyond 2^62 cells, as damaged floats
/// do, is in the last one, whose neighbours have numbers too.
inline std::int64_t cellNumber(double coordinate) {
  constexpr double kLast = 4611686018427387904.0;  // 2^62
  return static_cast<std::int64_t>(std::floor(std::clamp(coordinate, -kLast, kLast)));
}

}  // namespace tank_datum
