#pragma once

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Whether the second is the larger one, or the first is unknown.
inline bool isLarger(const PlacedValue& largest, const PlacedValue& candidate) {
  return !(candidate.value <= largest.value);
}

}  // namespace tank_datum
