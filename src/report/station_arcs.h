#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// First and last azimuth of every run of stations for which `is` holds [deg]; [0, 360] where it holds for all.
nlohmann::ordered_json arcsJson(const std::vector<char>& is, const std::vector<Station>& stations);

/// Of each station whether it is not measured for that reason.
std::vector<char> withReason(const std::vector<Station>& stations, Unmeasured reason);

/// Of each station whether it is in a gap in which what was refused may be the datum.
std::vector<char> inDoubt(const std::vector<Station>& stations);

/// The same where that may be a heave: not where the shell is seen below the level of the stations beside.
std::vector<char> maybeHeaved(const std::vector<Station>& stations);

/// The arcs in words, "45 to 91, 305 to 331 deg", the longest of many; empty: there is none.
/// @param shortest  number of stations of an arc that is named
std::string arcsText(const std::vector<char>& is, const std::vector<Station>& stations, std::size_t shortest);

}  // namespace tank_datum
