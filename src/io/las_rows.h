#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/record_rows.h"

namespace tank_datum {

/// Bytes of a point of formats 0 to 10, without what a file may add.
constexpr std::array<std::size_t, 11> kLasPointBytes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/// How the points of a LAS file are stored.
struct LasStorage {
  unsigned format = 0;  ///< 0 to 10
  std::size_t row_bytes = kLasPointBytes[0];
  std::array<double, 3> scales = {1.0, 1.0, 1.0}, shifts = {};
};

/// Such points as rows: x, y and z by scale and shift, the point source id as label, without those that are marked as
/// withheld. Where they are is left to the caller. Source: ASPRS, LAS Specification 1.4-R15.
/// @param classes  classification codes of the points that are wanted, 0 to 255; empty: all
RecordRows lasRows(const LasStorage& storage, const std::vector<int>& classes);

}  // namespace tank_datum
