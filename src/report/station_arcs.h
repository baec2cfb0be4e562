#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// First and last azimuth of every run of stations for which `is` holds [deg]; [0, 360] where it holds for all.
nlohmann::ordered_json arcsJson(const std::vector<char>& is, const std::vector<Station>& stations);

/// Of each station whether something else than the datum's surface meets the shell there: soil, a kerb.
std::vector<char> onOtherSurface(const std::vector<Station>& stations);

/// The arcs of three stations or more in words, "45 to 91, 305 to 331 deg", the longest of many; empty: there is none.
std::string arcsText(const std::vector<char>& is, const std::vector<Station>& stations);

}  // namespace tank_datum
