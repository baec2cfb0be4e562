#pragma once

#include "tank_datum/datum.h"

namespace tank_datum {

/// @throws Error (Option) naming the first refused option
void requireValid(const DatumOptions& options);

}  // namespace tank_datum
