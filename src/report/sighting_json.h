#pragma once

#include <string>

#include "tank_datum/datum.h"

namespace tank_datum {

/// What was looked at where no datum was found, as compact JSON for the report's page: the circle tried in the scan's
/// frame, or null, and the points as whole steps from its centre and foot.
std::string sightingJson(const Datum& datum);

}  // namespace tank_datum
