#pragma once

#include <vector>

#include "foot/foot_state.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Bridges across what was refused, with standard errors that hold it where a shell could follow it from the stations
/// beside: it looks like soil, but a heave of the foundation looks the same.
/// @param refused  elevations of what may be the datum nevertheless, else NaN [m]
std::vector<StationDatum> withRefusedDoubted(std::vector<StationDatum> stations, const std::vector<double>& refused,
                                             const Foot& foot);

}  // namespace tank_datum
