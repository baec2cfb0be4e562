#pragma once

#include <vector>

namespace tank_datum {

struct RayCounts;

/// What beams that come so steeply do to the points of a wide surface. Those near the shell meet the shell too.
struct BeamEffects {
  double to = 0;       ///< distance from the shell beyond which none meets it too; 0: not known [m]
  double lift = 0;     ///< of a point at the shell, as expected [m]
  double scatter = 0;  ///< of points about the surface, by range noise along them [m]

  /// Whether some that meet the surface beyond a distance from the shell meet the shell too.
  bool reach(double d) const { return d < to; }
  /// By how much they lift a point at a distance from the shell, as expected; the standard error is as large, for
  /// scanners that do not mix what a beam meets lift none [m].
  double liftAt(double d) const;
};

/// The same at windows round the ring, of beams that are as wide as those are that come so steeply from the height of
/// an eye. Each window goes by those beside it too: few rows of a scan may cross the surface in one.
/// @param from   where the surface begins [m]
/// @param reach  of the section [m]
/// @param noise  of ranges [m]
std::vector<BeamEffects> findBeamEffects(const std::vector<RayCounts>& windows, double from, double reach,
                                         double noise);

}  // namespace tank_datum
