#include "las_block.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <utility>

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// What iterating over a block yields, as every block of tank_datum/_foreign.py: points, setups, invalid, left_out.
py::tuple decoded(const LasBlock& las) {
  ScanBlocks::Block block;
  las.decode(1.0, block);
  const auto rows = static_cast<py::ssize_t>(block.points.size());
  const double* first = rows > 0 ? block.points.front().data() : nullptr;
  return py::make_tuple(py::array_t<double>({rows, py::ssize_t{3}}, first),
                        py::array_t<std::uint32_t>(rows, block.setups.data()), block.invalid, block.left_out);
}

}  // namespace

LasBlock::LasBlock(std::vector<Records> records, const LasStorage& storage, const std::vector<int>& classes,
                   std::uint64_t left_out)
    : records_(std::move(records)), left_out_(left_out) {
  const bool is_format = storage.format < kLasPointBytes.size();
  if (!is_format || storage.row_bytes < kLasPointBytes[storage.format]) {
    throw py::value_error("records shorter than their point format");
  }
  for (const Records& some : records_) {
    if (some.ndim() != 2 || static_cast<std::size_t>(some.shape(1)) != storage.row_bytes) {
      throw py::value_error("records of another length than their point format has");
    }
    parts_.push_back({reinterpret_cast<const char*>(some.data()), static_cast<std::size_t>(some.shape(0))});
    rows_ += parts_.back().rows;
  }
  stored_ = lasRows(storage, classes);
}

void LasBlock::decode(double metres_per_unit, ScanBlocks::Block& block) const {
  block.points.clear();
  block.setups.clear();
  block.points.reserve(rows_);
  block.setups.reserve(rows_);
  ScanCounts counts;
  BlockBuffer buffer;
  for (const Part& part : parts_) {
    for (std::size_t begin = 0, end = 0; begin < part.rows; begin = end) {
      end = std::min(part.rows, begin + kBlockRows);
      buffer.bytes.assign(part.bytes + begin * stored_.row_bytes, part.bytes + end * stored_.row_bytes);
      counts += decodeRecords(stored_, end - begin, {metres_per_unit}, {}, buffer);
      block.points.insert(block.points.end(), buffer.points.begin(), buffer.points.end());
      block.setups.insert(block.setups.end(), buffer.labels.begin(), buffer.labels.end());
    }
  }
  block.invalid = counts.invalid;
  block.left_out = counts.left_out + left_out_;
}

void addLasBlock(py::module_& module) {
  using Axes = std::array<double, 3>;
  const auto make = [](std::vector<LasBlock::Records> records, unsigned format, std::size_t row_bytes,
                       const Axes& scales, const Axes& shifts, const std::vector<int>& classes,
                       std::uint64_t left_out) {
    return LasBlock(std::move(records), {format, row_bytes, scales, shifts}, classes, left_out);
  };
  py::class_<LasBlock>(module, "LasBlock").def(py::init(make)).def("__iter__", [](const LasBlock& las) {
    return decoded(las).attr("__iter__")();
  });
}

}  // namespace tank_datum::python
