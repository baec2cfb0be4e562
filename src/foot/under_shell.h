#pragma once

#include <vector>

#include "foot/foot_state.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

/// Stations at which the foundation is seen to go on under the wall, as it does under cladding that ends above it: a
/// shell hides it.
struct UnderShell {
  std::vector<bool> seen;   ///< of each station
  double share = kUnknown;  ///< of the stations that tell; NaN where none does

  /// Whether that is so over a part of the ring only, and the wall elsewhere is the shell.
  bool isOfFew() const;
};

/// Below a hole in the wall, as cladding leaves above a plate's edge that stands out as far as it does, all that is
/// seen behind the wall is of the foot. What is seen behind it all the way up, or as a floor farther in than cladding
/// is thick, is seen through it or from inside, and tells nothing.
/// @param fits    not valid where a station does not stand
/// @param levels  of the foundation at every station, roughly [m]
UnderShell findUnderShell(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<double>& levels);

}  // namespace tank_datum
