#pragma once

#include "foot/foot_state.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// A few passes, each with the elevations of the one before; outliers of the last have no fit.
/// @param elevations  those after the last pass
FootPass runPasses(const Foot& foot, const Tank& tank, FootElevations& elevations);

}  // namespace tank_datum
