#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations that rise towards an arc beside them in which something else than the foundation is seen: soil fades in
/// there, and where it is thin it looks like the foundation. The first that rises is left out with all between it and
/// the arc.
/// @param levels  elevations of the stations that were fitted alone, else NaN [m]
/// @param sigmas  their standard errors [m]
std::vector<bool> findRises(const Foot& foot, const FootOutliers& outliers, const std::vector<double>& levels,
                            const std::vector<double>& sigmas);

}  // namespace tank_datum
