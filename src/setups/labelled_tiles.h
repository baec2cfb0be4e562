#pragma once

#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Makes one setup of those whose labels are equal, where the files are tiles of one labelled cloud.
/// @return whether they are, and hold two setups or more
bool joinLabelledTiles(Ring& ring, const Scan& scan, const Tank& tank, int threads);

}  // namespace tank_datum
