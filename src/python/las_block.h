#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

#include "io/las_rows.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::python {

/// Points as LAS stores them, decoded when they are asked for, some at a time.
class LasBlock {
 public:
  /// Of shape (points, bytes of a point), one after the other.
  using Records = pybind11::array_t<std::uint8_t, pybind11::array::c_style>;

  /// @param left_out  rows beside these that are not wanted
  /// @throws pybind11::value_error when records are shorter than their point format
  LasBlock(std::vector<Records> records, const LasStorage& storage, const std::vector<int>& classes,
           std::uint64_t left_out);

  /// How far they are decoded.
  struct Place {
    std::size_t part = 0, row = 0;
    BlockBuffer buffer = {};
  };

  /// Replaces the block's points by the next, few enough for a core's cache, and tells whether there are more behind
  /// them. The interpreter's lock is not needed.
  bool decode(double metres_per_unit, Place& place, ScanBlocks::Block& block) const;

 private:
  struct Part {
    const char* bytes = nullptr;
    std::size_t rows = 0;
  };

  std::vector<Records> records_;  // keeps the bytes of the parts
  std::vector<Part> parts_;
  RecordRows stored_;
  std::uint64_t left_out_;
};

void addLasBlock(pybind11::module_& module);

}  // namespace tank_datum::python
