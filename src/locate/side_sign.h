#pragma once

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Which way from the shell its foundation was seen: +1 outwards, -1 inwards.
inline double signOf(Side side) { return side == Side::Outside ? 1.0 : -1.0; }

}  // namespace tank_datum
