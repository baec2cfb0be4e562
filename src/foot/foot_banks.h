#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations that lie on soil against the shell: what is seen farther out lies lower below them than it does below the
/// stations round the ring, and they rise above their neighbours. (A foundation that is lower in a sector lies lower
/// below a plate that does not rise.)
/// @param surface  whose end what is farther out lies beyond
/// @param levels   elevations of the stations that stand, else NaN [m]
/// @param stood    stations that say what is usual: those that stood before they were fitted
std::vector<bool> findBanks(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels,
                            const std::vector<bool>& stood);

/// Stations in runs beside whose ends the shell is seen to go on below them: what they lie on is not what the shell
/// stands on. Of a run up to a sixth of the ring long one end says so, since a bank may fade at the other; of one up to
/// half of it both do, or the one whose shell is seen. A plate may be cut off there, and the shell go down by its
/// thickness.
/// @param surface  that the stations lie on
/// @param levels  elevations of the stations that stand, else NaN [m]
std::vector<bool> findHangingRuns(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels);

}  // namespace tank_datum
