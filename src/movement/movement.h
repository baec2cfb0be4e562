#pragma once

#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// @throws Error (Option) naming the first refused field
void requireValid(const MovementOptions& options);

/// Refuses a circle that is not that of the baseline's tank. The centre of a levelled baseline is not looked at.
/// @throws Error (Option) naming radius or centre, and the units that may have been confused
void requireSameTank(const Epoch& baseline, const std::string& name, const Circle& circle,
                     const MovementOptions& options);

/// Refuses a survey none of whose stations has a standard error.
/// @throws Error (Option) naming it and, of a levelling, the column that its table lacks
void requireErrors(const Epoch& epoch);

}  // namespace tank_datum
