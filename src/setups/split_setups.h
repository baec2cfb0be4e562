#pragma once

#include "setups/setup_ring.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/setups/setups.h"

namespace tank_datum {

/// Makes one setup of those that are parts of one: adjusted each for itself, their errors would pass for independent.
/// They are parts by their labels where equal ones are in several files that are tiles of one cloud, or of which each
/// holds shares of the setups, as of points that were dealt out; and by what they show of the shell where that is the
/// same but for chance, and dense enough to tell setups that stand a few degrees apart.
/// @param ring   whose points' setups are known
/// @param polar  the same points, with the setups that they have yet
SplitSetups joinSplitSetups(Ring& ring, const SetupRing& polar, const Scan& scan, const Tank& tank);

}  // namespace tank_datum
