#pragma once

#include "tank_datum/movement/movement.h"

namespace tank_datum {

struct AzimuthOffset {
  double value = 0.0;  ///< [rad]
  double sigma = 0.0;  ///< its standard error [rad]
};

/// The turn of the current survey at which the shapes out of plane agree best.
/// @throws Error (Option) when the shape does not single out one turn
AzimuthOffset estimateOffset(const Epoch& baseline, const Epoch& current, const MovementOptions& options);

/// Whether surveys of which no turn was given fit each other far better when one is turned: their azimuths may be
/// counted from different marks.
bool fitsTurned(const Epoch& baseline, const Epoch& current, const MovementOptions& options);

}  // namespace tank_datum
