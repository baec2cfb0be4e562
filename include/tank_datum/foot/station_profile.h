#pragma once

#include <cmath>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"

namespace TANK_DATUM_API tank_datum {

/// A scan point in the section across the shell at a station: distance d from the shell at the foot, positive on the
/// foundation's side, and elevation z [m].
struct SectionPoint {
  float d, z;
};

/// The section at one station as the refinement saw it, for the eye: a few of the points, and the two lines whose
/// intersection is the datum. Elevations are relative to `base`.
struct StationProfile {
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

}  // namespace tank_datum
