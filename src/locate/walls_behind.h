#pragma once

#include <vector>

#include "locate/wall_map.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Walls that stand behind a shell, where its own would hide them.
struct WallsBehind {
  double share = 0.0;     ///< of the azimuths at which the shell is seen
  double distance = 0.0;  ///< from the shell, the median over these azimuths of the furthest [m]
};

/// What stands behind a tank's shell as seen from its side: inside of the circle, or, where the foundation was seen
/// inside, outside of it and less than a radius away. Only walls count, at heights at which the shell stands: a roof,
/// and the far wall of an open tank seen from above, are none.
WallsBehind wallsBehind(const std::vector<WallCell>& walls, const Tank& tank);

}  // namespace tank_datum
