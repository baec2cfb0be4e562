#pragma once

#include <cstdint>

namespace tank_datum {

constexpr int kMortonBits = 21;  // of each axis; three make 63

/// Two zero bits between every two bits.
inline std::uint64_t spreadBits(std::uint64_t value) {
  value = (value | value << 32) & 0x001f00000000ffffULL;
  value = (value | value << 16) & 0x001f0000ff0000ffULL;
  value = (value | value << 8) & 0x100f00f00f00f00fULL;
  value = (value | value << 4) & 0x10c30c30c30c30c3ULL;
  return (value | value << 2) & 0x1249249249249249ULL;
}

/// The place of a cell on the Morton curve (Morton 1966), on which the cells of any cube of 2^n follow one another.
/// @param x,y,z  of kMortonBits
inline std::uint64_t mortonCode(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return spreadBits(x) | spreadBits(y) << 1 | spreadBits(z) << 2;
}

}  // namespace tank_datum
