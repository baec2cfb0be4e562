#pragma once

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// @throws Error (Option) naming the first refused field
void requireValid(const MovementOptions& options);

}  // namespace tank_datum
