#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The `movement` of datum.json and movement.json.
nlohmann::ordered_json movementSection(const Movement& movement);

/// The `stations` of datum.json: what a later survey is compared with.
nlohmann::ordered_json stationsSection(const Datum& datum);

}  // namespace tank_datum
