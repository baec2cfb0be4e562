#pragma once

#include "tank_datum/datum.h"

namespace tank_datum {

// The stages at the foot think in metres; where footUnit is another length, they are given the ring in it.

/// Lengths of a shell survey and of the crop in that unit [m].
DatumOptions inUnits(DatumOptions options, double unit);

/// A tank, and a ring, in units of `unit` metres.
Tank inUnits(Tank tank, double unit);
Ring inUnits(Ring ring, double unit);

/// Puts what was measured in units of `unit` metres into metres: the edge points, curve, stations, and what was
/// refined.
void putInMetres(Datum& datum, double unit);

}  // namespace tank_datum
