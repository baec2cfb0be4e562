#pragma once

#include <string>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Points a degree that the ring has beside the foot of the shell, on the foundation's side, where the shell and any of
/// them are seen: a foot that is hidden elsewhere is not sparse for that. NaN where none is seen.
double footDensity(const Ring& ring, const Tank& tank);

/// "1.2 foundation points a degree".
std::string footDensityText(double per_degree);

/// What there is to say of a foot with few points: "1.2 foundation points a degree; some 20 are needed"; nothing of a
/// dense one.
/// @param per_degree  points a degree
std::string sparseFoot(double per_degree);

/// What there is to say of stations so close that few have points of their own; nothing of others.
/// @param stations  round the tank
std::string fineStations(double per_degree, int stations);

}  // namespace tank_datum
