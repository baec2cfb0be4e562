#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Whether the shell is seen at a station by a good part below a level, as it is behind a kerb that stands before it.
/// @param fit  the level, with what is known of its errors and its course along the shell
bool goesOnBelow(const Foot& foot, std::size_t station, const FootFit& fit);

/// Stations that lie on soil against the shell: what is seen farther out lies lower below them than it does below the
/// stations round the ring, and they rise above their neighbours. (A foundation that is lower in a sector lies lower
/// below a plate that does not rise.)
/// @param levels  elevations of the stations that stand, else NaN [m]
std::vector<bool> findBanks(const Foot& foot, const std::vector<double>& levels);

/// Stations in runs beside whose ends the shell is seen to go on below them: what they lie on is not what the shell
/// stands on. Of a run up to a sixth of the ring long one end says so, since a bank may fade at the other; of one up to
/// half of it both do, or the one whose shell is seen.
/// @param levels  elevations of the stations that stand, else NaN [m]
std::vector<bool> findHangingRuns(const Foot& foot, const std::vector<double>& levels);

}  // namespace tank_datum
