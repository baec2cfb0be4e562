#pragma once

#include <limits>
#include <vector>

#include "foot/shell_line.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

struct ShellCircle {
  Circle circle;                   ///< at the datum [m]
  double sigma_radius = kUnknown;  ///< standard error, out-of-roundness included [m]
  std::vector<bool> strays;        ///< lines so far off it that they do not count; empty where none was fitted
};

/// How well the circle is known before the lines are looked at, from the shell over all of its height [m].
struct CirclePrior {
  double sigma_radius = std::numeric_limits<double>::infinity();
  double sigma_center = std::numeric_limits<double>::infinity();
};

/// What a located tank's circle is worth: more than nothing only where half of the shell or more was seen.
CirclePrior priorOf(const Tank& tank);

/// One circle and one lean through the stations' shell lines, each taken at two heights: a short arc bears that better
/// than the stations' own radii at the datum, extrapolated one by one. Robust; every station counts the same, however
/// densely it was scanned.
/// @param azimuths  of the lines [rad]
/// @param heights   above the datum between which the lines were fitted
/// @param start     the circle that the lines' radii are measured from the centre of
/// @param prior     of that circle
/// @param sure      lines that are the shell's; where they are most of those seen the fit begins with them, for what
///                  stands elsewhere, cladding on a part of the ring, may be off by more than it bears
ShellCircle fitShellCircle(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths,
                           const ShellHeights& heights, const Circle& start, const CirclePrior& prior,
                           const std::vector<bool>& sure);

}  // namespace tank_datum
