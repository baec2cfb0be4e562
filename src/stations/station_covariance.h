#pragma once

#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The covariance of stations that share nothing: sigma_z each.
StationCovariance independentCovariance(const std::vector<Station>& stations);

/// Whether the covariance is of so many stations, each shared error known at each of them: of default make it is of
/// any number.
bool fits(const StationCovariance& covariance, const std::vector<Station>& stations);

}  // namespace tank_datum
