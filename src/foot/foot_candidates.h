#pragma once

#include <vector>

#include "foot/foot_profile.h"

namespace tank_datum {

/// A flat stretch of the section at one station that the shell might stand on.
struct FootCandidate {
  double height = 0;       ///< of its line at the shell [m]
  double error = 0;        ///< standard error of that [m]
  double slope = 0;        ///< rising outwards [m/m]
  double sigma_slope = 0;  ///< [m/m]
  double from = 0;         ///< where it begins, from the shell [m]
  double to = 0;           ///< and ends [m]
  double noise = 0;        ///< standard deviation of its points, typical [m]
  double over_foot = 0;    ///< how far the shell is seen below it; negative where it ends above [m]
};

/// The flat stretches of a section, the nearest to the shell first: runs of bins without a step, the lowest layer
/// counts in each.
/// @param points  of a window of azimuth, over the section's whole reach
/// @param bottom  from where on points were looked for, far below any foot [m]
std::vector<FootCandidate> findCandidates(const std::vector<FootPoint>& points, const FootScales& scales,
                                          double bottom);

}  // namespace tank_datum
