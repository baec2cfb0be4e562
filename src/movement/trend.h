#pragma once

#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The time of a date as "2024-05-31" or a decimal year as "2024.41" [years].
/// @throws Error (Option) for anything else, a date that there is not included
double yearOf(const std::string& date);

}  // namespace tank_datum
