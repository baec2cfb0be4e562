#pragma once

#include <functional>
#include <string>

#include "tank_datum/setups/setups.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What a reader must mind of the setups: bad ones by name, what they alone saw, repeated points, scans merged without
/// labels that disagree. Empty when there is nothing.
std::string setupMessage(const SetupAgreement& agreement, const std::vector<Station>& stations);

/// "6, disagreeing by 2.1 mm, adjusted; shared error 0.9 mm".
/// @param length  of a short length [m], in the units that are shown
std::string setupSummary(const SetupAgreement& agreement, const std::vector<Station>& stations,
                         const std::function<std::string(double)>& length);

}  // namespace tank_datum
