#pragma once

#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The largest difference of z, over the arc between the two places: |z(l + arc) - z(l)| / arc.
/// @param quantity  &Station::z or &Station::u
PlacedValue steepest(const std::vector<Station>& stations, double radius, double arc, double Station::*quantity);

/// Half of highest minus lowest z within an arc, where it is largest (API 650 7.5.5: "+- so much in any 9 m").
PlacedValue unevennessWithin(const std::vector<Station>& stations, double radius, double arc);

/// The largest |z - mean|.
PlacedValue unevennessOfAll(const std::vector<Station>& stations);

}  // namespace tank_datum
