#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The `movement` of datum.json and movement.json.
nlohmann::ordered_json movementSection(const Movement& movement);

/// The `limits` of a movement or of a trend: how the judged figures go towards their limits; figures in metres, metres
/// a metre or 1/m, a year.
nlohmann::ordered_json limitRatesSection(const LimitRates& rates);

/// The `stations` of datum.json: what a later survey is compared with.
nlohmann::ordered_json stationsSection(const Datum& datum);

}  // namespace tank_datum
