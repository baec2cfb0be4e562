#pragma once

#include <cstdint>
#include <optional>

#include "shell/shell_bands.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The points at the shell from the ring's upper end up to where the highest ringwall's face ends, gathered in the same
/// pass over the scan as the ring.
class WallAbove {
 public:
  /// @param reach  of the ring [m]
  /// @param points  of the scan: of more than kPointsLookedAt every n-th one is looked at
  WallAbove(const Tank& tank, double reach, std::uint64_t points);

  /// From any number of threads.
  void gather(std::uint64_t n, const Points& block) {
    if (bands_) bands_->gather(n, block);
  }
  /// None of a tank of which mayStandOnNarrowRingwall() does not hold. Some are there twice.
  Points points() const;

 private:
  std::optional<ShellBands> bands_;
};

}  // namespace tank_datum
