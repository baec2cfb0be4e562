#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/report/report.h"

namespace tank_datum {

/// What datum.json says, key by key in its order. Metres, degrees; null where unknown.
nlohmann::ordered_json datumRecord(const Datum& datum, const Provenance& provenance);

/// What readers are told of the tank and in which units and language: keys for what was given.
void addTold(nlohmann::ordered_json& json, const Identity& identity);

}  // namespace tank_datum
