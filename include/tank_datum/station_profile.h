#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "tank_datum/export.h"
#include "tank_datum/foot_fit.h"
#include "tank_datum/shell_line.h"

namespace TANK_DATUM_API tank_datum {

/// A scan point in the section across the shell at a station: distance d from the shell at the foot, positive on the
/// foundation's side, and elevation z [m].
struct SectionPoint {
  float d, z;
};

/// The section at one station as the refinement saw it, for the eye: a few of the points, and the two lines whose
/// intersection is the datum. Elevations are relative to `base`.
struct StationProfile {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double base = 0;                   ///< elevation the section is drawn about [m]
  std::vector<SectionPoint> points;  ///< a third each, at most, of the shell, the band that was fitted, and what else
  double foundation = kUnknown;      ///< elevation of the foundation's line at d = 0, above base [m]
  double slope = kUnknown;           ///< of that line [m/m]
  double noise = kUnknown;           ///< standard deviation of the foundation's points about it [m]
  double lean = kUnknown;            ///< of the shell's line d = lean * (height above its foot) [m/m]
  double shell_noise = kUnknown;     ///< standard deviation of the shell's points about it [m]

  bool hasFoundation() const { return std::isfinite(slope); }
  bool hasShell() const { return std::isfinite(lean); }
};

/// Where a section is taken.
struct ProfileWindow {
  double direction;  ///< of the station [rad]
  double half_step;  ///< half the angle its own points come from [rad]; a station with few takes its fit's window
  double base;       ///< elevation of the foot there [m]
  double reach;      ///< of the section in distance and height [m]
  double band_to;    ///< how far out the foundation's line was fitted [m]
  double side;       ///< +1 when the foundation lies outside of the shell, -1 inside
};

/// The section at a station.
/// @param wanted  how many points to keep at most, evenly taken from those of each part
StationProfile profileOf(const FootRing& ring, const ProfileWindow& window, const FootFit& fit, const ShellLine& shell,
                         int wanted);

}  // namespace tank_datum
