#pragma once

#include "tank_datum/datum.h"

namespace tank_datum {

/// Of two datums the tank's: of a shell that stands on a narrow ringwall, or of one that steps back above its foot, as
/// upon a skirt. A datum that is refused or doubtful is none; and a shell that has a plate well below the step stands
/// on that.
/// @param upper  above the step
/// @param lower  where the wall ends
Datum upperOrLower(Datum upper, Datum lower);

}  // namespace tank_datum
