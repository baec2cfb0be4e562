#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "io/coordinates.h"

namespace tank_datum {

class InputFile;

/// One number of a row of fixed length.
struct RecordColumn {
  std::size_t offset = 0;  ///< bytes before it in the row
  StoredNumber number = {};
};

/// Which rows are points: those whose class is wanted and that are not marked as deleted.
struct RowFilter {
  std::size_t class_offset = 0;  ///< of the byte that has the class in the row
  unsigned class_bits = 0xffU;
  std::size_t deleted_offset = 0;
  unsigned deleted_bit = 0;
  std::array<bool, 256> wanted{};

  bool keeps(const char* row) const {
    return wanted[static_cast<unsigned char>(row[class_offset]) & class_bits] &&
           (static_cast<unsigned char>(row[deleted_offset]) & deleted_bit) == 0;
  }
};

/// Rows of one fixed length in a file: the points of a LAS, a binary PCD or a binary PLY file.
struct RecordRows {
  std::uint64_t offset = 0;  ///< bytes before the first row
  std::uint64_t rows = 0;
  std::size_t row_bytes = 0;
  std::array<RecordColumn, 3> xyz{};
  std::optional<RecordColumn> label;
  std::optional<RowFilter> filter;
};

/// Blocks of such rows. Each can be decoded by itself, in any order, in any thread with a buffer of its own.
std::uint64_t recordBlockCount(const RecordRows& records);

/// Fills buffer.points with the finite ones of the chosen points of one block, and buffer.labels.
/// @return of all rows of the block
/// @throws Error (File) when the file has become shorter
ScanCounts decodeRecordBlock(const InputFile& file, const RecordRows& records, const Frame& frame,
                             const BlockRows& chosen, BlockBuffer& buffer);

/// The same of so many rows that buffer.bytes holds; what they hold is lost.
ScanCounts decodeRecords(const RecordRows& records, std::size_t rows, const Frame& frame, const RowChoice& chosen,
                         BlockBuffer& buffer);

/// The longest step of the three coordinates at a place of the scan's frame [m].
double stepAt(const std::array<RecordColumn, 3>& xyz, const Eigen::Vector3d& place, double metres_per_unit);

}  // namespace tank_datum
