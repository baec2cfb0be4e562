#pragma once

#include <vector>

#include "tank_datum/foot/refined.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What the refinement found: for the tank as a whole, and at each station.
struct RefinedFoot {
  Refined refined;
  std::vector<StationDatum> stations;  ///< empty where the shell was seen nowhere
};

/// Intersects, station by station, a robust local fit of the shell with one of the foundation surface that meets it.
RefinedFoot refineStations(const Ring& ring, const Tank& tank, const RefineOptions& options,
                           const StationOptions& station_options);

}  // namespace tank_datum
