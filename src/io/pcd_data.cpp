#include "io/pcd_data.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <memory>

#include "io/coordinates.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

/// How a coordinate is stored: relative to an origin where the notes say so.
StoredNumber numberOf(const PcdHeader& header, std::size_t axis) {
  const PcdColumn& column = header.columns[header.xyz[axis]];
  StoredNumber number{column.type, column.size};
  number.shift = header.notes.origin[axis];
  number.scaled = header.notes.origin != std::array<double, 3>{};
  number.step = header.notes.step;
  return number;
}

/// x, y and z of fields stored one after the other, from row begin on.
CoordinateColumns columnsOfFields(const PcdHeader& header, const char* fields, std::size_t begin) {
  CoordinateColumns xyz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PcdColumn& column = header.columns[header.xyz[axis]];
    const auto stride = static_cast<std::size_t>(column.size);
    xyz[axis] = {fields + column.offset * header.points + begin * stride, stride, numberOf(header, axis)};
  }
  return xyz;
}

RecordColumn columnOf(const PcdColumn& column) { return {column.offset, {column.type, column.size}}; }

/// The fields of a compressed file, not initialised first: they may be gigabytes.
std::unique_ptr<char[]> decompress(const InputFile& file, const PcdHeader& header) {
  const std::size_t size = header.points * header.row_bytes;  // fits 32 bits, see checkPcdSize
  std::unique_ptr<char[]> packed(new char[header.compressed_bytes]);
  std::unique_ptr<char[]> fields(new char[size]);
  file.read(header.data_offset + 2 * sizeof(std::uint32_t), packed.get(), header.compressed_bytes);
  const std::size_t got =
      lzf_decompress(packed.get(), header.compressed_bytes, fields.get(), static_cast<unsigned>(size));
  if (got != size) {
    throw fileError("compressed data", file.path(), got == 0 ? "damaged" : std::to_string(got) + " bytes",
                    "LZF data of " + std::to_string(size) + " bytes");
  }
  return fields;
}

}  // namespace

RecordRows recordRowsOf(const PcdHeader& header) {
  RecordRows records{header.data_offset, header.points, header.row_bytes, xyzOf(header), {}, {}};
  if (header.label) records.label = columnOf(header.columns[*header.label]);
  return records;
}

std::array<RecordColumn, 3> xyzOf(const PcdHeader& header) {
  std::array<RecordColumn, 3> xyz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    xyz[axis] = {header.columns[header.xyz[axis]].offset, numberOf(header, axis)};
  }
  return xyz;
}

ScanCounts visitCompressed(const InputFile& file, const PcdHeader& header, const Frame& frame,
                           const BlockVisitor& visit) {
  ScanCounts counts;
  if (header.points == 0) return counts;
  const std::unique_ptr<char[]> fields = decompress(file, header);
  Points points;
  Labels labels;
  while (counts.points < header.points) {
    const std::size_t rows = std::min<std::size_t>(kBlockRows, header.points - counts.points);
    const CoordinateColumns xyz = columnsOfFields(header, fields.get(), counts.points);
    decodeRows(xyz, rows, frame, points);
    if (header.label) {
      const PcdColumn& column = header.columns[*header.label];
      const auto stride = static_cast<std::size_t>(column.size);
      const char* first = fields.get() + column.offset * header.points + counts.points * stride;
      decodeLabels({first, stride, {column.type, column.size}}, xyz, rows, frame, labels);
    }
    counts += {rows, rows - points.size()};
    if (!points.empty() && !visit(points, labels)) break;
  }
  return counts;
}

}  // namespace tank_datum
