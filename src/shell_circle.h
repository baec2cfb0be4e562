#pragma once

#include <vector>

#include "tank_datum/circle.h"
#include "tank_datum/shell_line.h"

namespace tank_datum {

struct ShellCircle {
  Circle circle;                              ///< at the datum [m]
  double sigma_radius = ShellLine::kUnknown;  ///< standard error, out-of-roundness included [m]
};

/// One circle and one lean through the stations' shell lines, each taken at two heights: a short arc bears that better
/// than the stations' own radii at the datum, extrapolated one by one. Robust; every station counts the same, however
/// densely it was scanned.
/// @param azimuths  of the lines [rad]
/// @param from,to   heights above the datum between which the lines were fitted [m]
/// @param start     the circle that the lines' radii are measured from the centre of
ShellCircle fitShellCircle(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths, double from,
                           double to, const Circle& start);

}  // namespace tank_datum
