#pragma once

#include <string>
#include <vector>

#include "tank_datum/datum.h"

namespace tank_datum {

/// Stations of a levelling survey from a table with the columns azimuth_deg, elevation and, where known, sigma (the
/// standard error of an elevation). An empty elevation is a missing station. Rows may stand in any order.
/// @param file             its name, for messages
/// @param metres_per_unit  of elevation and sigma
/// @param diameter         of the tank [m]
/// @throws Error (Option) naming file, line and what is wrong
std::vector<Station> levellingStations(const std::string& text, const std::string& file, double metres_per_unit,
                                       double diameter, const StationOptions& options);

}  // namespace tank_datum
