#pragma once

#include <cstdint>

namespace tank_datum {

/// std::floor of a value that fits into 63 bits, without the call that it is where SSE 4.1 may not be used.
inline double fastFloor(double value) {
  const auto whole = static_cast<double>(static_cast<std::int64_t>(value));
  return whole > value ? whole - 1.0 : whole;
}

}  // namespace tank_datum
