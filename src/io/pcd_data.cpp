#include "io/pcd_data.h"

#include <liblzf/lzf.h>

#include <algorithm>
#include <memory>

#include "io/coordinates.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{4} << 20;  // wide rows: fewer of them to a block

std::size_t rowsPerBlock(const PcdHeader& header) {
  return std::clamp<std::size_t>(kBlockBytes / header.row_bytes, 1, kBlockRows);
}

/// x, y and z of the chosen ones of rows stored one after the other.
CoordinateColumns columnsOfRows(const PcdHeader& header, const char* rows, const RowChoice& choice) {
  CoordinateColumns xyz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PcdColumn& column = header.columns[header.xyz[axis]];
    xyz[axis] = {rows + choice.first * header.row_bytes + column.offset, choice.step * header.row_bytes, column.type,
                 column.size};
  }
  return xyz;
}

/// x, y and z of fields stored one after the other, from row begin on.
CoordinateColumns columnsOfFields(const PcdHeader& header, const char* fields, std::size_t begin) {
  CoordinateColumns xyz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PcdColumn& column = header.columns[header.xyz[axis]];
    const auto stride = static_cast<std::size_t>(column.size);
    xyz[axis] = {fields + column.offset * header.points + begin * stride, stride, column.type, column.size};
  }
  return xyz;
}

CoordinateColumn columnOf(const PcdColumn& column, const char* first, std::size_t stride) {
  return {first, stride, column.type, column.size};
}

ScanCounts visitBinary(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit) {
  ScanCounts counts;
  BlockBuffer buffer;
  for (std::uint64_t block = 0; block < binaryBlockCount(header); ++block) {
    counts += decodeBinaryBlock(file, header, frame, {block}, buffer);
    if (!buffer.points.empty() && !visit(buffer.points, buffer.labels)) break;
  }
  return counts;
}

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
      decodeLabels(columnOf(column, first, stride), xyz, rows, frame, labels);
    }
    counts += {rows, rows - points.size()};
    if (!points.empty() && !visit(points, labels)) break;
  }
  return counts;
}

}  // namespace

std::uint64_t binaryBlockCount(const PcdHeader& header) {
  const std::size_t rows = rowsPerBlock(header);
  return header.points / rows + (header.points % rows != 0 ? 1 : 0);
}

ScanCounts decodeBinaryBlock(const InputFile& file, const PcdHeader& header, const Frame& frame,
                             const BlockRows& chosen, BlockBuffer& buffer) {
  const RowChoice& choice = chosen.choice;
  const std::uint64_t begin = chosen.block * rowsPerBlock(header);
  const std::size_t rows = std::min<std::size_t>(rowsPerBlock(header), header.points - begin);
  buffer.bytes.resize(rows * header.row_bytes);
  file.read(header.data_offset + begin * header.row_bytes, buffer.bytes.data(), buffer.bytes.size());
  const CoordinateColumns xyz = columnsOfRows(header, buffer.bytes.data(), choice);
  decodeRows(xyz, choice.of(rows), frame, buffer.points);
  buffer.labels.clear();  // of the file that the buffer held before
  if (header.label) {
    const PcdColumn& column = header.columns[*header.label];
    const char* first = buffer.bytes.data() + choice.first * header.row_bytes + column.offset;
    decodeLabels(columnOf(column, first, choice.step * header.row_bytes), xyz, choice.of(rows), frame, buffer.labels);
  }
  if (choice.step == 1) return {rows, rows - buffer.points.size()};
  return {rows, countInvalid(columnsOfRows(header, buffer.bytes.data(), {}), rows, frame)};
}

ScanCounts visitPcd(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit) {
  switch (header.encoding) {
    case PcdEncoding::Ascii:
      return visitAscii(file, header, frame, visit);
    case PcdEncoding::Binary:
      return visitBinary(file, header, frame, visit);
    case PcdEncoding::BinaryCompressed:
      return visitCompressed(file, header, frame, visit);
  }
  return {};
}

}  // namespace tank_datum
