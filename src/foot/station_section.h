#pragma once

#include "foot/foot_fit.h"
#include "foot/shell_line.h"
#include "tank_datum/foot/refined.h"

namespace tank_datum {

/// What all sections of a tank share.
struct ProfileBand {
  double to;    ///< how far out the foundation's line was fitted [m]
  double side;  ///< +1 when the foundation lies outside of the shell, -1 inside
};

/// Where a section is taken.
struct ProfileWindow {
  double direction;  ///< of the station [rad]
  double half_step;  ///< half the angle its own points come from [rad]; a station with few takes its fit's window
  double base;       ///< elevation of the foot there [m]
  double reach;      ///< of the section in distance and height [m]
  ProfileBand band;
};

/// The section at a station.
/// @param wanted  how many points to keep at most, evenly taken from those of each part
StationProfile profileOf(const FootRing& ring, const ProfileWindow& window, const FootFit& fit, const ShellLine& shell,
                         int wanted);

}  // namespace tank_datum
