#pragma once

#include <vector>

#include "foot/foot_profile.h"

namespace tank_datum {

/// Stacks the stations' points by their distance from the shell: a profile's bins, with height, spread and error.
/// @param datum  elevation of each station [m]; NaN where it is to be left out
void stackBins(FootProfile& profile, const std::vector<std::vector<FootPoint>>& stations,
               const std::vector<double>& datum, const FootScales& scales);

}  // namespace tank_datum
