#pragma once

#include "tank_datum/datum.h"

namespace tank_datum {

/// @throws Error (Option) naming the first refused option
void requireValid(const DatumOptions& options);

/// The scan turned about the tank's foot so that the shell, whose lean is known, stands upright.
Scan levelled(const Scan& scan, const Datum& datum);

}  // namespace tank_datum
