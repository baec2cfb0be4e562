#pragma once

#include <string>
#include <vector>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// Whether centres say whether it is the same tank: in a frame that both surveys share.
bool shareFrame(const Epoch& baseline, const MovementOptions& options);

/// What is removed from the differences of two surveys, or of some from the first: never Removal::Auto.
Removal removalOf(const Epoch& baseline, const Epoch& current, const MovementOptions& options);
Removal removalOf(const std::vector<Epoch>& surveys, const MovementOptions& options);

/// Refuses a circle that is not that of the baseline's tank. The centre of a levelled baseline is not looked at.
/// @throws Error (Option) naming radius or centre, and the units that may have been confused
void requireSameTank(const Epoch& baseline, const std::string& name, const Circle& circle,
                     const MovementOptions& options);

/// Refuses a survey none of whose stations has a standard error.
/// @throws Error (Option) naming it and, of a levelling, the column that its table lacks
void requireErrors(const Epoch& epoch);

/// Refuses surveys of different tanks, by different methods or without errors.
/// @throws Error (Option) naming what differs
void requireComparable(const Epoch& baseline, const Epoch& current, const MovementOptions& options);

/// Refuses surveys one of which stands on annular plates and the other on what they lie on, a plate's thickness below.
/// Names are read from sections, and those of one surface may differ where its edge is far out or hidden: where the
/// mean movement is known to be less than half of the thinnest plate, it is one surface. Foundation and ringwall are.
/// @param movement  whose mean is known
/// @throws Error (Option) naming the surfaces
void requireSameSurface(const Epoch& baseline, const Epoch& current, const Movement& movement);

}  // namespace tank_datum
