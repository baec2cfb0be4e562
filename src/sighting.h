#pragma once

#include "tank_datum/datum.h"

namespace tank_datum {

/// A datum that is not usable with what was looked at, and three things to try; any other as it is.
Datum withSighting(Datum datum, const Scan& scan, const DatumOptions& options);

}  // namespace tank_datum
