#pragma once

#include <cstddef>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Keeps the points of a ring that keep(number of the point) says, in their order, with their setups.
template <typename Keep>
void keepPoints(Ring& ring, const Keep& keep) {
  const bool told = !ring.point_setups.empty();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    if (!keep(i)) continue;
    ring.points[kept] = ring.points[i];
    if (told) ring.point_setups[kept] = ring.point_setups[i];
    ++kept;
  }
  ring.points.resize(kept);
  if (told) ring.point_setups.resize(kept);
}

}  // namespace tank_datum
