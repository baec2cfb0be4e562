#pragma once

#include <vector>

#include "shell/shell_grid.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The shell off the vertical at one station; the offset is NaN where it is seen at fewer than two heights.
Plumbness plumbnessAt(const ShellGrid& grid, std::size_t station, const Station& place);

/// The same at every station seen at two heights, the offsets smoothed along the shell as far as its shape allows, so
/// that the largest of many noisy ones is not taken for the shell's.
std::vector<Plumbness> plumbnessOf(const ShellGrid& grid, const std::vector<Station>& stations);

}  // namespace tank_datum
