#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// LAS files made byte by byte, after the ASPRS specification.
namespace tank_datum::las_files {

struct Point {
  std::array<std::int32_t, 3> stored{};
  unsigned code = 2;  ///< classification
  bool withheld = false;
  unsigned source = 0;  ///< point source id
};

struct Las {
  unsigned minor = 2;
  unsigned format = 0;
  std::size_t extra_bytes = 0;  ///< of a point, behind what the format has
  std::array<double, 3> scale{0.001, 0.001, 0.001};
  std::array<double, 3> shift{};
  std::size_t gap = 0;  ///< bytes of variable length records
  std::vector<Point> points;
};

template <typename T>
void put(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

inline std::size_t headerBytes(const Las& las) { return las.minor == 4 ? 375 : las.minor == 3 ? 235 : 227; }

inline std::string bytesOf(const Las& las, const Point& point) {
  constexpr std::array<std::size_t, 11> kBytes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  std::string row(kBytes[las.format] + las.extra_bytes, '\x7f');
  for (std::size_t axis = 0; axis < 3; ++axis) put(row, 4 * axis, point.stored[axis]);
  if (las.format < 6) {
    put<std::uint8_t>(row, 15, static_cast<std::uint8_t>(point.code | (point.withheld ? 0x80U : 0x60U)));
    put<std::uint16_t>(row, 18, static_cast<std::uint16_t>(point.source));
  } else {
    put<std::uint8_t>(row, 15, static_cast<std::uint8_t>(point.withheld ? 0x04 : 0xfb));
    put<std::uint8_t>(row, 16, static_cast<std::uint8_t>(point.code));
    put<std::uint16_t>(row, 20, static_cast<std::uint16_t>(point.source));
  }
  return row;
}

inline std::string las(const Las& las) {
  std::string bytes(headerBytes(las) + las.gap, '\0');
  std::string rows;
  for (const Point& point : las.points) rows += bytesOf(las, point);
  const auto count = las.points.size();
  bytes.replace(0, 4, "LASF");
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, static_cast<std::uint8_t>(las.minor));
  put<std::uint16_t>(bytes, 94, static_cast<std::uint16_t>(headerBytes(las)));
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(bytes.size()));
  put<std::uint8_t>(bytes, 104, static_cast<std::uint8_t>(las.format));
  put<std::uint16_t>(bytes, 105, static_cast<std::uint16_t>(bytesOf(las, {}).size()));
  if (las.minor < 4) put<std::uint32_t>(bytes, 107, static_cast<std::uint32_t>(count));
  if (las.minor == 4) put<std::uint64_t>(bytes, 247, count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(bytes, 131 + 8 * axis, las.scale[axis]);
    put(bytes, 155 + 8 * axis, las.shift[axis]);
  }
  return bytes + rows;
}

}  // namespace tank_datum::las_files
