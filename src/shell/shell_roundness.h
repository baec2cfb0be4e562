#pragma once

#include <vector>

#include "shell/shell_grid.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Whether a height counts as the one foot at which radii are measured.
bool isAtFoot(double height);

/// The shell at one height against its own circle, and the deviation of every station, NaN where it is not seen.
/// @param datum_circle  about whose centre the radii are [m]
/// @return without a valid circle where less than half of the shell is seen, or a gap is wider than 120 degrees
Roundness roundnessOf(const std::vector<ShellCell>& row, double height, const std::vector<Station>& stations,
                      const Circle& datum_circle, std::vector<double>& deviations);

/// The shell at a height whose own circle is not known, against one that it may have: what that is off its middle is in
/// sigma.
/// @return without a valid circle where few stations see the shell
Roundness arcOf(const std::vector<ShellCell>& row, double height, const std::vector<Station>& stations,
                const Circle& datum_circle, const Circle& expected);

}  // namespace tank_datum
