#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/foot/foot_profile.h"
#include "tank_datum/foot/station_profile.h"
#include "tank_datum/locate/crop.h"
#include "tank_datum/locate/locate.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

struct RefineOptions {
  double largest_weld = 0.013;   ///< leg of the fillet weld in the corner that is kept out of the fits [m]
  double widest_band = 0.3;      ///< the foundation surface is followed no further from the shell [m]
  double widest_window = 1.0;    ///< half the arc that a sparse station may borrow points from [m], at most 10 degrees
  double wanted_sigma = 0.0001;  ///< a station leans on its neighbours unless its own standard error is this good [m]
  int profile_points = 0;        ///< points of each station's section kept for the report; moves no result
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const RefineOptions& options);

/// What the refinement found for the tank as a whole.
struct Refined {
  FootProfile profile;                   ///< the section of the foot, and which surface was intersected
  Circle circle;                         ///< of the shell at the datum, from the stations [m]
  double sigma_radius = kUnknown;        ///< standard error of its radius [m]
  std::vector<StationProfile> sections;  ///< one per station where RefineOptions::profile_points > 0, else none

  bool valid() const { return profile.valid(); }
};

/// Intersects, station by station, a robust local fit of the shell with one of the foundation surface that meets it.
/// Fills z, radius, their standard errors, the point counts and the flags measured or missing.
Refined refineStations(std::vector<Station>& stations, const Ring& ring, const Tank& tank, const RefineOptions& options,
                       const StationOptions& station_options);

}  // namespace tank_datum
