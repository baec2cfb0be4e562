#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/shape/analysis.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Adds `harmonics`, `out_of_plane`, `local_settlements`, `foundation`, `checks`, `verdict` and `notes` to a
/// datum.json. Metres, degrees.
/// @param z_origin  added to the mean elevation [m]
void addAnalysis(nlohmann::ordered_json& json, const Analysis& analysis, const std::vector<Station>& stations,
                 double z_origin);

}  // namespace tank_datum
