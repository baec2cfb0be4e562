#pragma once

#include <string>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum::view {

/// stations.csv read back: what a viewer shows of each station, relative to `origin` [m].
/// @throws Error (File) naming the file, the line and the cell that is no number
std::vector<Station> readStations(const std::string& path, const Eigen::Vector3d& origin);

}  // namespace tank_datum::view
