#pragma once

#include "io/scan_source.h"

namespace tank_datum {

/// A source whose blocks can be decoded by themselves, in any order, in any thread.
class BlockSource : public Scan::Source {
 public:
  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override;
  void choose(const Eigen::Vector3d& origin, const Choice& choice, int threads, std::uint64_t& block,
              const ChosenVisitor& told) const override;

 protected:
  virtual std::uint64_t blockCount() const = 0;

  /// Fills buffer.points with the finite ones of the chosen points of one block, and buffer.labels.
  /// @return of all rows of the block
  virtual ScanCounts decode(const Eigen::Vector3d& origin, const BlockRows& chosen, BlockBuffer& buffer) const = 0;
};

/// Scan::Source::choose by a visit, for what cannot be read from any place: only the choice is thinned.
void chooseInOrder(const Scan::Source& source, const Eigen::Vector3d& origin, const Scan::Source::Choice& choice,
                   std::uint64_t& block, const Scan::Source::ChosenVisitor& told);

}  // namespace tank_datum
