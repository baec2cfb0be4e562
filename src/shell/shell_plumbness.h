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

/// What the slopes have in common, as a lean of the whole; not valid with too few of them, nor where its interval (95
/// %) is wider than any shell leans: over a short arc a lean and a taper are alike.
/// @param options  how azimuths are counted
Lean leanOf(const std::vector<Plumbness>& plumbness, const StationOptions& options);

}  // namespace tank_datum
