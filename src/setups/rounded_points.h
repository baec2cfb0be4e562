#pragma once

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Spreads coordinates that were rounded evenly over their steps, as they may have been before: what is alike by
/// rounding only would pass for known without an error. ring.rounding is the step of z then, the largest of the
/// setups'.
/// @param unit  footUnit() of the tank
void spreadRounded(Ring& ring, double unit);

}  // namespace tank_datum
