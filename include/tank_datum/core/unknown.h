#pragma once

#include <limits>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A number that is not known: NaN here, null in JSON, an empty cell in CSV.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace tank_datum
