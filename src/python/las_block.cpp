#include "las_block.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// What iterating over a block yields, as every block of tank_datum/_foreign.py: points, setups, invalid, left_out.
py::tuple decoded(const LasBlock& las) {
  LasBlock::Place place;
  ScanBlocks::Block some, all;
  for (bool more = true; more;) {
    more = las.decode(1.0, place, some);
    all.points.insert(all.points.end(), some.points.begin(), some.points.end());
    all.setups.insert(all.setups.end(), some.setups.begin(), some.setups.end());
    all.invalid += some.invalid;
    all.left_out += some.left_out;
  }
  const auto rows = static_cast<py::ssize_t>(all.points.size());
  const double* first = rows > 0 ? all.points.front().data() : nullptr;
  return py::make_tuple(py::array_t<double>({rows, py::ssize_t{3}}, first),
                        py::array_t<std::uint32_t>(rows, all.setups.data()), all.invalid, all.left_out);
}

/// Memory for records. NumPy asks for huge pages for its own, which takes longer here than it saves: they are cleared
/// as a whole, and used once.
LasBlock::Records roomFor(py::ssize_t rows, py::ssize_t row_bytes) {
  std::unique_ptr<std::uint8_t[]> bytes(new std::uint8_t[static_cast<std::size_t>(rows * row_bytes)]);
  const py::capsule owner(bytes.get(), [](void* owned) { delete[] static_cast<std::uint8_t*>(owned); });
  const std::uint8_t* first = bytes.release();
  return LasBlock::Records({rows, row_bytes}, first, owner);
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
  }
  stored_ = lasRows(storage, classes);
}

bool LasBlock::decode(double metres_per_unit, Place& place, ScanBlocks::Block& block) const {
  const bool begins = place.part == 0 && place.row == 0;
  std::size_t rows = 0;
  if (place.part < parts_.size()) {
    const Part& part = parts_[place.part];
    const char* first = part.bytes + place.row * stored_.row_bytes;
    rows = std::min(part.rows - place.row, kBlockRows);
    place.buffer.bytes.assign(first, first + rows * stored_.row_bytes);
    place.row += rows;
    if (place.row == part.rows) ++place.part, place.row = 0;
  }
  const ScanCounts counts = decodeRecords(stored_, rows, {metres_per_unit}, {}, place.buffer);
  std::swap(block.points, place.buffer.points);
  std::swap(block.setups, place.buffer.labels);
  block.invalid = counts.invalid;
  block.left_out = counts.left_out + (begins ? left_out_ : 0);
  return place.part < parts_.size();
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
  module.def("las_records", &roomFor);
}

}  // namespace tank_datum::python
