#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

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

/// Which rows of a block are looked at: every step-th from the first.
struct RowChoice {
  std::size_t first = 0, step = 1;

  /// How many of so many rows these are.
  std::size_t of(std::size_t rows) const { return rows > first ? (rows - first - 1) / step + 1 : 0; }
};

/// A block of a file, and its rows that are looked at.
struct BlockRows {
  std::uint64_t block = 0;
  RowChoice choice = {};
};

}  // namespace tank_datum
