#pragma once

#include <cstddef>
#include <vector>

#include "foot/polar_ring.h"
#include "shell/shell_row.h"

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

/// What the shell does between the arc's ends.
struct ShellTrace {
  bool runs_on = false;             ///< traced from column to column of its points, as over a dent or a peaked weld
  std::vector<ShellCell> stations;  ///< between the ends, steps - 1 of them, where it runs on
  double stepped = 0.0;  ///< by how much the radius is seen to step, as at the edges of what stands before it [m]
};

ShellTrace traceShell(const PolarRing& ring, const ShellArc& arc);

}  // namespace tank_datum
