#include "io/record_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/input_file.h"

namespace tank_datum {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{4} << 20;  // wide rows: fewer of them to a block

std::size_t rowsPerBlock(const RecordRows& records) {
  return std::clamp<std::size_t>(kBlockBytes / records.row_bytes, 1, kBlockRows);
}

CoordinateColumn columnOf(const RecordRows& records, const RecordColumn& column, const char* rows,
                          const RowChoice& choice) {
  return {rows + choice.first * records.row_bytes + column.offset, choice.step * records.row_bytes, column.number};
}

CoordinateColumns columnsOf(const RecordRows& records, const char* rows, const RowChoice& choice) {
  return {columnOf(records, records.xyz[0], rows, choice), columnOf(records, records.xyz[1], rows, choice),
          columnOf(records, records.xyz[2], rows, choice)};
}

/// How many rows the filter leaves out.
std::size_t countLeftOut(const RecordRows& records, const char* rows, std::size_t count) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    kept += static_cast<std::size_t>(records.filter->keeps(rows + i * records.row_bytes));
  }
  return count - kept;
}

/// Moves the chosen rows that the filter keeps to the front; how many these are.
std::size_t keepWanted(const RecordRows& records, char* rows, std::size_t count, const RowChoice& choice) {
  std::size_t kept = 0;
  for (std::size_t i = choice.first; i < count; i += choice.step) {
    const char* row = rows + i * records.row_bytes;
    if (records.filter->keeps(row)) std::memmove(rows + kept++ * records.row_bytes, row, records.row_bytes);
  }
  return kept;
}

}  // namespace

std::uint64_t recordBlockCount(const RecordRows& records) {
  const std::size_t rows = rowsPerBlock(records);
  return records.rows / rows + (records.rows % rows != 0 ? 1 : 0);
}

ScanCounts decodeRecordBlock(const InputFile& file, const RecordRows& records, const Frame& frame,
                             const BlockRows& chosen, BlockBuffer& buffer) {
  const std::uint64_t begin = chosen.block * rowsPerBlock(records);
  const std::size_t rows = std::min<std::size_t>(rowsPerBlock(records), records.rows - begin);
  buffer.bytes.resize(rows * records.row_bytes);
  file.read(records.offset + begin * records.row_bytes, buffer.bytes.data(), buffer.bytes.size());
  return decodeRecords(records, rows, frame, chosen.choice, buffer);
}

ScanCounts decodeRecords(const RecordRows& records, std::size_t rows, const Frame& frame, const RowChoice& chosen,
                         BlockBuffer& buffer) {
  RowChoice choice = chosen;
  ScanCounts counts{rows, 0};
  std::size_t looked_at = choice.of(rows);
  if (choice.step != 1) counts.invalid = countInvalid(columnsOf(records, buffer.bytes.data(), {}), rows, frame);
  if (records.filter) counts.left_out = countLeftOut(records, buffer.bytes.data(), rows);
  if (counts.left_out > 0) {
    looked_at = keepWanted(records, buffer.bytes.data(), rows, choice);
    choice = {};
  }
  const CoordinateColumns xyz = columnsOf(records, buffer.bytes.data(), choice);
  decodeRows(xyz, looked_at, frame, buffer.points);
  buffer.labels.clear();  // of the file that the buffer held before
  if (records.label) {
    decodeLabels(columnOf(records, *records.label, buffer.bytes.data(), choice), xyz, looked_at, frame, buffer.labels);
  }
  if (chosen.step == 1) counts.invalid = looked_at - buffer.points.size();
  return counts;
}

double stepAt(const std::array<RecordColumn, 3>& xyz, const Eigen::Vector3d& place, double metres_per_unit) {
  double step = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double stored = std::abs(place[axis]) / metres_per_unit;
    step = std::max(step, stepAt(xyz[static_cast<std::size_t>(axis)].number, stored) * metres_per_unit);
  }
  return step;
}

}  // namespace tank_datum
