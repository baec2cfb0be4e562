#pragma once

#include <array>
#include <cstddef>

#include "io/block.h"

namespace tank_datum {

/// How a number is stored. Stored numbers are in the byte order of this machine unless swapped.
struct StoredNumber {
  char type = 'F';  ///< 'F' float, 'I' signed, 'U' unsigned
  int size = 4;     ///< bytes
  bool swapped = false;
  bool scaled = false;  ///< stored * scale + shift is meant; fast of I of 4 bytes and of F of 8, not swapped
  double scale = 1.0, shift = 0.0;
  double step = 0.0;  ///< to the next that was measured; 0: to the next that can be stored
};

/// One number of many rows somewhere in memory, unaligned.
struct CoordinateColumn {
  const char* first = nullptr;
  std::size_t stride = 0;  ///< bytes from one row to the next
  StoredNumber number = {};
};

/// Appends the point if all of it is finite in the frame, else returns false.
inline bool appendFinite(const Eigen::Vector3d& stored, const Frame& frame, Points& points) {
  const Eigen::Vector3d point = stored * frame.metres_per_unit - frame.origin;
  if (!point.allFinite()) return false;
  points.push_back(point);
  return true;
}

using CoordinateColumns = std::array<CoordinateColumn, 3>;

/// Replaces points by the finite ones of the rows, in order.
void decodeRows(const CoordinateColumns& xyz, std::size_t rows, const Frame& frame, Points& points);

/// What a field of labels says, as a number; SetupKey::kUnlabelled for what is no whole number from 0 on.
std::uint32_t labelOf(double value);

/// Replaces labels by those of the finite rows, in order, as decodeRows has their points.
void decodeLabels(const CoordinateColumn& label, const CoordinateColumns& xyz, std::size_t rows, const Frame& frame,
                  Labels& labels);

/// How many of the rows decodeRows would leave out.
std::size_t countInvalid(const CoordinateColumns& xyz, std::size_t rows, const Frame& frame);

/// From a value to the next that can be stored, both in the file's units; 0 of whole numbers without a scale.
double stepAt(const StoredNumber& number, double value);

}  // namespace tank_datum
