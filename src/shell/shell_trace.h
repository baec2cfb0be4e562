#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "foot/polar_ring.h"
#include "shell/shell_grid.h"

namespace tank_datum {

/// An arc of one height of the shell, between two stations.
struct ShellArc {
  double from, to;        ///< azimuths, to > from [rad]
  double z_from, z_to;    ///< of the height at either end [m]
  double half_band;       ///< the points are that far above or below it [m]
  double radius;          ///< of the shell, roughly [m]
  double noise;           ///< usual spread of its points [m]
  std::size_t steps = 1;  ///< from station to station
  ShellCell first, last;  ///< the shell at its ends
};

/// The shell at the stations between the arc's ends, steps - 1 of them, traced from column to column of its points;
/// nothing where it cannot be: a dent or a peaked weld runs on, what stands before the shell begins and ends with a
/// jump.
std::optional<std::vector<ShellCell>> traceShell(const PolarRing& ring, const ShellArc& arc);

}  // namespace tank_datum
