#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// What was there twice.
struct RepeatedPoints {
  std::size_t removed = 0;        ///< points that were there already
  std::vector<double> of_setups;  ///< share of each setup's points that were removed
};

/// Leaves out points whose coordinates another point of the ring has exactly: a file given twice, a cloud that holds
/// each point several times. Coordinates of a few digits meet by chance; so nothing is removed unless three in ten of
/// some setup's points are repetitions.
RepeatedPoints removeRepeated(Ring& ring);

}  // namespace tank_datum
