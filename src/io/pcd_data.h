#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "io/input_file.h"
#include "io/pcd_header.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// From stored coordinates to a scan's: stored * metres_per_unit - origin.
struct Frame {
  double metres_per_unit = 1.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< [m]
};

/// What the field of labels says of each point of a block; empty where there is no such field.
using Labels = std::vector<std::uint32_t>;

/// Receives the next block, which is never empty; false ends the pass.
using BlockVisitor = std::function<bool(const Points& block, const Labels& labels)>;

/// Rows of a block at most; its bytes and its points together stay in a core's L2 cache.
constexpr std::size_t kBlockRows = 16384;

/// Memory of one block, to be used again for the next.
struct BlockBuffer {
  std::vector<char> bytes;
  Points points;
  Labels labels;
};

/// Blocks of a binary file. Each can be decoded by itself, in any order, in any thread with a buffer of its own.
std::uint64_t binaryBlockCount(const PcdHeader& header);

/// Which rows of a block are looked at: every step-th from the first.
struct RowChoice {
  std::size_t first = 0, step = 1;

  /// How many of so many rows these are.
  std::size_t of(std::size_t rows) const { return rows > first ? (rows - first - 1) / step + 1 : 0; }
};

/// A block of a binary file, and its rows that are looked at.
struct BlockRows {
  std::uint64_t block = 0;
  RowChoice choice = {};
};

/// Fills buffer.points with the finite ones of the chosen points of one block of a binary file, and buffer.labels.
/// @return of all rows of the block
/// @throws Error (File) when the file has become shorter
ScanCounts decodeBinaryBlock(const InputFile& file, const PcdHeader& header, const Frame& frame,
                             const BlockRows& chosen, BlockBuffer& buffer);

/// Visits the finite points of a PCD file of any encoding in file order. Memory is that of a block, but for
/// binary_compressed, which is one LZF block and needs its compressed and its uncompressed size.
/// @return the rows seen, all of them unless the visitor ended the pass
/// @throws Error (File) when the data are not what the header says
ScanCounts visitPcd(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit);

/// The ascii part of visitPcd. Values are separated by blanks, tabs or one comma each; a row has exactly
/// header.row_values of them. Empty lines and those that begin with # are skipped, as is what follows the last row and
/// does not begin with a number. More rows than POINTS are refused as fewer are.
ScanCounts visitAscii(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit);

}  // namespace tank_datum
