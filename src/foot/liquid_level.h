#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Where a floor is seen to lie as liquid or sludge that stands in the tank does.
struct LiquidLevel {
  std::vector<bool> stations;  ///< that lie on it; empty: none
  double share = 0;  ///< of all that are fitted; 1: a level floor without slope looks the same; 0: none is told
};

/// Stations of long arcs on one level surface that has no slope, while the floor beside it has one, or climbs along the
/// shell more than a tilted floor that is level there, and lies nowhere lower.
/// @param fits  of the datum; not valid where a station does not stand
/// @param own   the surfaces as the stations' own points lie; not valid where a station does not stand
LiquidLevel findLiquidLevel(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<FootFit>& own);

/// Leaves out the stations upon liquid: the floor lies below. Where all lie so, none is left out. Seen from outside,
/// liquid is not looked for: a foundation may be paved level.
FootPass withoutLiquid(const Foot& foot, FootPass pass);

}  // namespace tank_datum
