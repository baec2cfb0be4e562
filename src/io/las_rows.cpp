#include "io/las_rows.h"

namespace tank_datum {
namespace {

RowFilter filterOf(unsigned format, const std::vector<int>& classes) {
  RowFilter filter;
  if (format < 6) {
    filter = {15, 0x1f, 15, 0x80, {}};
  } else {
    filter = {16, 0xff, 15, 0x04, {}};
  }
  filter.wanted.fill(classes.empty());
  for (const int code : classes) filter.wanted[static_cast<std::size_t>(code)] = true;
  return filter;
}

}  // namespace

RecordRows lasRows(const LasStorage& storage, const std::vector<int>& classes) {
  RecordRows rows;
  rows.row_bytes = storage.row_bytes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows.xyz[axis] = {4 * axis, {'I', 4, false, true, storage.scales[axis], storage.shifts[axis]}};
  }
  rows.label = RecordColumn{storage.format < 6 ? 18U : 20U, {'U', 2}};
  rows.filter = filterOf(storage.format, classes);
  return rows;
}

}  // namespace tank_datum
