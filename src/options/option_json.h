#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "options/option_table.h"

namespace tank_datum {

/// The values as datum.json's `options` has them, each at its place. Metres, degrees; not given: null.
nlohmann::ordered_json optionsJson(const RunOptions& run);
/// Those of a comparison, without the name of their section.
nlohmann::ordered_json movementValues(const MovementOptions& movement);

/// What there is to say of each option, as a JSON list in the order of the table: name, kind, unit, default, what it
/// must be, help. From it come src/doc/options.md and the keywords of the Python stub.
std::string optionsListed();

}  // namespace tank_datum
