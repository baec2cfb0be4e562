#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/report/report.h"

namespace tank_datum {

/// What datum.json says, key by key in its order. Metres, degrees; null where unknown.
nlohmann::ordered_json datumRecord(const Datum& datum, const Provenance& provenance);

}  // namespace tank_datum
