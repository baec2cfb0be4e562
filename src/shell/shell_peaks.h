#pragma once

#include <vector>

#include "shell/shell_grid.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Raises the largest deviation of each height by what the shell does between the places that are looked at: as a
/// parabola through the largest and those beside it has its peak between them, along the shell and, of the heights,
/// above and below. It is known no better than that is much, and a narrower one may rise still more: as much as what
/// lies beside it differs, of a peak hardly wider than the places lie apart.
/// @param deviations  of every height and station, NaN where they are not known [m]
void raisePeaks(std::vector<Roundness>& roundness, const ShellGrid& grid,
                const std::vector<std::vector<double>>& deviations, const std::vector<Station>& stations);

}  // namespace tank_datum
