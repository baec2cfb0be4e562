#pragma once

#include <vector>

#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "tank_datum/locate/locate.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The shell at every station.
struct ShellFits {
  std::vector<ShellLine> lines;  ///< one per station, not seen() where the shell is not in view
  double from = 0, to = 0;       ///< heights above the foot between which points are surely shell [m]

  double noise() const;  ///< median of the lines' [m]; NaN when none was seen
};

/// Fits the shell at every station; sparse stations borrow points from a few degrees around.
/// @param reach  how far above the foot to look [m]
ShellFits fitShell(const std::vector<Station>& stations, const PolarRing& ring, const Tank& tank, double reach);

/// The lines as one surface round the tank.
ShellModel modelShell(std::vector<ShellLine> lines, const StationOptions& options);

}  // namespace tank_datum
