#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/block.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// One file, or one array, of a scan.
class Scan::Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t size() const = 0;
  virtual double coordinateStep(const Eigen::Vector3d& origin) const = 0;

  /// All finite points in order, block by block, until the visitor ends it.
  virtual ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const = 0;

  /// Of about every n-th row, what is chosen of each block.
  struct Choice {
    const Chooser& choose;
    std::uint64_t n = 1;
    bool of_parts = false;  ///< parts may be left unread, their rows told as left out
  };
  /// Told the rows read since the last call, and what was chosen of them, all of one label.
  using ChosenVisitor = std::function<void(const ScanCounts& read, const Points& chosen, std::uint32_t label)>;

  /// @param block  number of the source's first block; raised by the blocks read
  virtual void choose(const Eigen::Vector3d& origin, const Choice& choice, int threads, std::uint64_t& block,
                      const ChosenVisitor& told) const = 0;

  /// The field that tells the setups of one file apart; empty when there is none.
  virtual std::string labelField() const { return {}; }

  /// What a label is called; empty: its points are those of the file itself.
  virtual std::string labelName(std::uint32_t label) const {
    return label == SetupKey::kUnlabelled ? "none" : std::to_string(label);
  }

  /// The labels that there are, where this is known without a pass over the points; else empty.
  virtual std::vector<std::uint32_t> labels() const { return {}; }

  /// The same source of the points of some labels alone, where it can pass over the others; else nothing.
  virtual std::shared_ptr<const Source> ofLabels(const std::vector<std::uint32_t>&) const { return nullptr; }

  /// Where the scanner of a label stood [m], in the scan's own frame, if the file says so.
  virtual std::optional<Eigen::Vector3d> viewpoint(std::uint32_t) const { return std::nullopt; }
};

std::shared_ptr<const Scan::Source> arraySource(std::uint64_t rows, Scan::Row row, RowNumbers numbers);
/// @throws Error (Option) when blocks has no start
std::shared_ptr<const Scan::Source> streamSource(ScanBlocks blocks);

}  // namespace tank_datum
