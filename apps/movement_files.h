#pragma once

#include <string>
#include <vector>

#include "tank_datum/movement.h"

namespace tank_datum {

/// The median level of detection of the compared stations [m].
double medianLod(const Movement& movement);

/// movement.csv: one row per station of the last survey: azimuth_deg, trend (metres per survey: the least-squares slope
/// of dz over the surveys, the baseline's 0 included), its standard error, then dz, lod95 and significant of each
/// survey. Surveys with other station counts than the last give no dz here; movement.json has them whole.
std::string movementCsv(const std::vector<Movement>& movements);

/// Writes movement.json and movement.csv, whole or not at all.
/// @throws Error (File)
void writeMovement(const std::string& folder, const std::vector<Movement>& movements, const std::vector<Epoch>& epochs);

}  // namespace tank_datum
