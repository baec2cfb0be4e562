#include "io/coordinates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace tank_datum {
namespace {

template <typename T>
double loadAs(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return static_cast<double>(value);
}

/// Of the other byte order.
template <typename T>
double loadSwapped(const char* from) {
  char bytes[sizeof(T)];
  std::reverse_copy(from, from + sizeof(T), bytes);
  return loadAs<T>(bytes);
}

using Load = double (*)(const char*);

template <typename T>
Load loadOf(bool swapped) {
  return swapped ? loadSwapped<T> : loadAs<T>;
}

/// Of the number as it is stored, without its scale.
Load loadOf(const StoredNumber& number) {
  const bool swapped = number.swapped;
  if (number.type == 'F') return number.size == 4 ? loadOf<float>(swapped) : loadOf<double>(swapped);
  const bool is_signed = number.type == 'I';
  switch (number.size) {
    case 1:
      return is_signed ? loadAs<std::int8_t> : loadAs<std::uint8_t>;
    case 2:
      return is_signed ? loadOf<std::int16_t>(swapped) : loadOf<std::uint16_t>(swapped);
    case 4:
      return is_signed ? loadOf<std::int32_t>(swapped) : loadOf<std::uint32_t>(swapped);
    default:
      return is_signed ? loadOf<std::int64_t>(swapped) : loadOf<std::uint64_t>(swapped);
  }
}

/// A stored number, scaled where it is.
struct LoadNumber {
  Load load;
  bool scaled;
  double scale, shift;

  explicit LoadNumber(const StoredNumber& number)
      : load(loadOf(number)), scaled(number.scaled), scale(number.scale), shift(number.shift) {}
  double operator()(const char* from) const { return scaled ? load(from) * scale + shift : load(from); }
};

bool allFinite(const CoordinateColumns& xyz, const Frame& frame) {
  constexpr double kLargest = 0x1p64;  // of what is stored as a whole number
  return std::all_of(xyz.begin(), xyz.end(), [&frame](const CoordinateColumn& column) {
    const StoredNumber& number = column.number;
    const double most = std::abs(number.scale) * kLargest + std::abs(number.shift);
    return number.type != 'F' && std::isfinite(most * frame.metres_per_unit);
  });
}

/// The loop itself; load(axis, from) is inlined where the type is known when compiling.
template <typename LoadAxis>
std::size_t decode(const CoordinateColumns& xyz, std::size_t rows, const Frame& frame, LoadAxis load, double* to) {
  const double scale = frame.metres_per_unit;
  const double ox = frame.origin.x(), oy = frame.origin.y(), oz = frame.origin.z();
  const char *from_x = xyz[0].first, *from_y = xyz[1].first, *from_z = xyz[2].first;
  const std::size_t step_x = xyz[0].stride, step_y = xyz[1].stride, step_z = xyz[2].stride;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const double x = load(0, from_x + i * step_x) * scale - ox;
    const double y = load(1, from_y + i * step_y) * scale - oy;
    const double z = load(2, from_z + i * step_z) * scale - oz;
    to[3 * kept] = x;
    to[3 * kept + 1] = y;
    to[3 * kept + 2] = z;
    // 0 times a finite number is 0, times anything else NaN; no branch, as NaN may be every second row
    kept += static_cast<std::size_t>(x * 0.0 + y * 0.0 + z * 0.0 == 0.0);
  }
  return kept;
}

/// Labels that no test is needed of, as LAS has them.
void copyShort(const CoordinateColumn& label, std::size_t rows, Labels& labels) {
  labels.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    std::uint16_t stored = 0;
    std::memcpy(&stored, label.first + i * label.stride, sizeof stored);
    labels[i] = stored;
  }
}

}  // namespace

void decodeRows(const CoordinateColumns& xyz, std::size_t rows, const Frame& frame, Points& points) {
  if (rows == 0) return points.clear();
  points.resize(rows);
  double* to = points.front().data();
  const auto all_are = [&](Load one, bool scaled) {
    return std::all_of(xyz.begin(), xyz.end(), [&](const CoordinateColumn& column) {
      return loadOf(column.number) == one && column.number.scaled == scaled;
    });
  };
  const std::array<double, 3> scales = {xyz[0].number.scale, xyz[1].number.scale, xyz[2].number.scale};
  const std::array<double, 3> shifts = {xyz[0].number.shift, xyz[1].number.shift, xyz[2].number.shift};
  std::size_t kept = 0;
  if (all_are(loadAs<float>, false)) {
    kept = decode(
        xyz, rows, frame, [](int, const char* from) { return loadAs<float>(from); }, to);
  } else if (all_are(loadAs<double>, false)) {
    kept = decode(
        xyz, rows, frame, [](int, const char* from) { return loadAs<double>(from); }, to);
  } else if (all_are(loadAs<double>, true)) {
    const auto load = [&](std::size_t axis, const char* from) {
      return loadAs<double>(from) * scales[axis] + shifts[axis];
    };
    kept = decode(xyz, rows, frame, load, to);
  } else if (all_are(loadAs<std::int32_t>, true)) {
    const auto load = [&](std::size_t axis, const char* from) {
      return loadAs<std::int32_t>(from) * scales[axis] + shifts[axis];
    };
    kept = decode(xyz, rows, frame, load, to);
  } else {
    const std::array<LoadNumber, 3> loads = {LoadNumber(xyz[0].number), LoadNumber(xyz[1].number),
                                             LoadNumber(xyz[2].number)};
    kept = decode(
        xyz, rows, frame, [&](std::size_t axis, const char* from) { return loads[axis](from); }, to);
  }
  points.resize(kept);
}

std::uint32_t labelOf(double value) {
  const double whole = std::nearbyint(value);
  return whole >= 0.0 && whole < static_cast<double>(SetupKey::kUnlabelled) ? static_cast<std::uint32_t>(whole)
                                                                            : SetupKey::kUnlabelled;
}

void decodeLabels(const CoordinateColumn& label, const CoordinateColumns& xyz, std::size_t rows, const Frame& frame,
                  Labels& labels) {
  labels.clear();
  const std::array<LoadNumber, 3> loads = {LoadNumber(xyz[0].number), LoadNumber(xyz[1].number),
                                           LoadNumber(xyz[2].number)};
  const LoadNumber load(label.number);
  const bool all_finite = allFinite(xyz, frame);
  const auto is_short = label.number.type == 'U' && label.number.size == 2 && !label.number.swapped;
  if (all_finite && is_short && !label.number.scaled) return copyShort(label, rows, labels);
  for (std::size_t i = 0; i < rows; ++i) {
    bool finite = true;
    for (std::size_t axis = 0; axis < 3 && !all_finite; ++axis) {
      const double stored = loads[axis](xyz[axis].first + i * xyz[axis].stride);
      finite = finite && std::isfinite(stored * frame.metres_per_unit - frame.origin[static_cast<Eigen::Index>(axis)]);
    }
    if (finite) labels.push_back(labelOf(load(label.first + i * label.stride)));
  }
}

std::size_t countInvalid(const CoordinateColumns& xyz, std::size_t rows, const Frame& frame) {
  if (allFinite(xyz, frame)) return 0;
  const auto is_float = [](const CoordinateColumn& column) {
    return column.number.type == 'F' && column.number.size == 4 && !column.number.swapped;
  };
  const bool stays_finite =
      std::isfinite(frame.metres_per_unit * static_cast<double>(std::numeric_limits<float>::max()));
  if (!std::all_of(xyz.begin(), xyz.end(), is_float) || !stays_finite) {
    thread_local Points points;
    decodeRows(xyz, rows, frame, points);
    return rows - points.size();
  }
  const auto is_finite = [](const char* from) {
    constexpr std::uint32_t kExponent = 0x7f800000U;  // all of it set: infinite or not a number
    std::uint32_t bits = 0;
    std::memcpy(&bits, from, sizeof bits);
    return static_cast<unsigned>((bits & kExponent) != kExponent);
  };
  std::size_t finite = 0;
  const char *x = xyz[0].first, *y = xyz[1].first, *z = xyz[2].first;
  for (std::size_t i = 0; i < rows; ++i, x += xyz[0].stride, y += xyz[1].stride, z += xyz[2].stride) {
    finite += is_finite(x) & is_finite(y) & is_finite(z);
  }
  return rows - finite;
}

double stepAt(const StoredNumber& number, double value) {
  if (number.step > 0.0) return number.step;
  if (number.type != 'F') return number.scaled ? number.scale : 0.0;
  if (number.size == 8) return std::nextafter(value, HUGE_VAL) - value;
  const float stored = static_cast<float>(value);
  return static_cast<double>(std::nextafter(stored, HUGE_VALF)) - static_cast<double>(stored);
}

}  // namespace tank_datum
