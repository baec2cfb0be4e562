#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {

/// An angle as one from 0 to a full turn, to which a tiny negative one rounds [rad].
inline double withinTurn(double angle) { return angle - kTwoPi * std::floor(angle / kTwoPi); }

/// An azimuth in whole degrees, 0 to 359.
inline double wholeDegrees(double azimuth) { return std::fmod(std::round(toDegrees(azimuth)), 360.0); }

/// The azimuth of a direction (x, y), counter-clockwise from x: 0 or more, and less than a full turn, to which that of
/// a tiny negative y rounds [rad].
inline double azimuthOfArm(double x, double y) {
  const double azimuth = portable::atan2(y, x);
  return azimuth >= 0.0 ? azimuth : std::min(azimuth + kTwoPi, std::nextafter(kTwoPi, 0.0));
}

/// The widest arc between neighbours of some azimuths within a turn; a turn of fewer than two [rad].
inline double widestArc(std::vector<double> azimuths) {
  if (azimuths.empty()) return kTwoPi;
  std::sort(azimuths.begin(), azimuths.end());
  double widest = azimuths.front() + kTwoPi - azimuths.back();
  for (std::size_t i = 1; i < azimuths.size(); ++i) widest = std::max(widest, azimuths[i] - azimuths[i - 1]);
  return widest;
}

}  // namespace tank_datum
