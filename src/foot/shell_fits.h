#pragma once

#include <vector>

#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The shell at every station.
struct ShellFits {
  std::vector<ShellLine> lines;  ///< one per station, not seen() where the shell is not in view or clad
  ShellHeights heights;          ///< that the lines were fitted between
  std::vector<bool> clad;        ///< stations at which something wide stands before the shell

  double noise() const;  ///< median of the lines' [m]; NaN when none was seen
};

/// Fits the shell in every direction; sparse stations borrow points from a few degrees around.
/// @param reach  how far above the foot to look [m]
ShellFits fitShellLines(const std::vector<double>& directions, const PolarRing& ring, const Tank& tank, double reach);

}  // namespace tank_datum
