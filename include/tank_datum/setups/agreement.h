#pragma once

#include "tank_datum/crop.h"
#include "tank_datum/export.h"
#include "tank_datum/locate.h"
#include "tank_datum/scan.h"
#include "tank_datum/setups/setups.h"

namespace TANK_DATUM_API tank_datum {

/// Finds how the setups of a ring disagree, from the arcs that two or more of them see, and moves each setup's points
/// by its correction. A ring of one setup is left as it is.
/// @param scan     names the setups and their origins
/// @param threads  0 means all cores; the result does not depend on it
SetupAgreement agreeSetups(Ring& ring, const Scan& scan, const Tank& tank, const SetupOptions& options,
                           int threads = 0);

}  // namespace tank_datum
