#pragma once

#include "setups/setup_ring.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Makes one setup of those whose labels are equal, where the files are tiles of one labelled cloud.
/// @param ring   whose points' setups are known
/// @param polar  the same points, with the setups that they have yet
/// @return whether they are, and hold two setups or more
bool joinLabelledTiles(Ring& ring, const SetupRing& polar, const Scan& scan, const Tank& tank);

}  // namespace tank_datum
