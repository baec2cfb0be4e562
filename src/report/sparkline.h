#pragma once

#include <cstddef>
#include <string>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Elevation against azimuth as a row of UTF-8 blocks, lowest to highest; a blank where no station of a column is
/// known.
/// @param columns  characters wide; fewer when there are fewer stations
std::string sparkline(const std::vector<Station>& stations, std::size_t columns);

}  // namespace tank_datum
