#pragma once

#include <vector>

#include "foot/foot_state.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Gaps with z_refused where a shell could follow what was refused in them from the stations beside: it looks like
/// soil, but a heave of the foundation looks the same. The standard errors of their bridges hold it.
/// @param refused  elevations of what may be the datum nevertheless, else NaN [m]
std::vector<StationDatum> withRefusedDoubted(std::vector<StationDatum> stations, const std::vector<double>& refused,
                                             const Foot& foot);

}  // namespace tank_datum
