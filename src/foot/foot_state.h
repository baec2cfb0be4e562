#pragma once

#include <vector>

#include "foot/foot_fit.h"
#include "tank_datum/foot/refine.h"

namespace tank_datum {

/// The foot as the passes see it; vectors are indexed by station.
struct Foot {
  const FootRing& ring;
  const RefineOptions& options;
  double reach;                                ///< of the ring [m]
  double half_step;                            ///< half the angle between stations [rad]
  double radius;                               ///< of the shell, roughly [m]
  std::vector<double> directions;              ///< [rad]
  std::vector<std::vector<FootPoint>> points;  ///< of each station's own stretch
  std::vector<double> datum;                   ///< elevation as known so far, filled up in gaps [m]
  std::vector<FootFit> fits;
};

/// Stations whose fit has no support of its own, lies on something else, or steps off its neighbours.
std::vector<bool> findStrangers(const Foot& foot, const std::vector<ShellLine>& shell, const FootProfile& profile,
                                const FootPrior& prior);

/// Elevations to stack the next section with: without strangers, unless they are most of what there is.
std::vector<double> withoutStrangers(const std::vector<double>& elevations, const std::vector<bool>& strange);

}  // namespace tank_datum
