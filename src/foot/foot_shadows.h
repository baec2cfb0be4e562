#pragma once

#include <vector>

#include "foot/foot_roughness.h"
#include "foot/foot_state.h"

namespace tank_datum {

/// What rays see of a rough surface, whose heights and slopes are normally distributed and alike to all sides: they
/// meet its heights and pass over its hollows, the more the flatter they come (Smith 1967).
struct SeenHeights {
  double lift;    ///< of the mean of what is seen above the surface's [m]
  double spread;  ///< standard deviation of what is seen [m]
};

/// @param steepness  tangent of the rays' angle to the surface
SeenHeights seenHeights(double steepness, const Roughness& roughness);

/// The roughness of which rays see what they see.
/// @param seen  of what is seen; its patches are taken to be the surface's
Roughness unshadowed(const Roughness& seen, double steepness);

/// The stations whose sigmas hold what the shadows of a rough surface may lift them by, bridges too; no elevation
/// moves.
std::vector<StationDatum> withShadowsDoubted(std::vector<StationDatum> stations, const Foot& foot,
                                             const FootPass& pass);

}  // namespace tank_datum
