#pragma once

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// A quantity at a place round the tank.
struct PlacedValue {
  double value = kUnknown;    ///< [m], or [m/m] of a slope
  double sigma = kUnknown;    ///< its standard error, unknown when the stations' are
  double azimuth = kUnknown;  ///< [rad]
};

/// 95 % interval of a figure; unknown when the errors are.
struct Interval95 {
  double low = kUnknown, high = kUnknown;

  bool known() const { return low <= high; }
};

/// Whether the second is the larger one, or the first is unknown.
inline bool isLarger(const PlacedValue& largest, const PlacedValue& candidate) {
  return !(candidate.value <= largest.value);
}

}  // namespace tank_datum
