#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tank_datum/foot/refined.h"

namespace tank_datum {

/// A point near the shell foot: arc t from its station, distance d from the shell towards the scanner's side, elevation
/// z [m].
struct FootPoint {
  double t, d, z;
};

/// Scales that the section is read with, all from the data or the object's size.
struct FootScales {
  double reach;         ///< how far out the section goes [m]
  double shell_noise;   ///< of points about the shell [m]
  double weld;          ///< the largest fillet weld to expect in the corner [m]
  bool arc = false;     ///< of an arc, which goes by the whole ring's section where its own does not show a lip's edge
  double overhang = 0;  ///< to where the whole ring's lip stands over what carries it [m]

  /// Width over which an edge may be blurred [m].
  double blur() const { return 4.0 * shell_noise; }
  /// Where the foundation begins: beyond the weld and the shell's noise [m].
  double nearest() const { return std::max(weld, 3.0 * shell_noise); }
};

/// Distance of a bin's middle from the shell [m].
inline double middle(const FootProfile& profile, std::size_t bin) {
  return (static_cast<double>(bin) + 0.5) * profile.bin;
}

/// The first bin that neither weld nor the shell's noise reaches.
inline std::size_t firstBeyondWeld(const FootProfile& profile, const FootScales& scales) {
  return static_cast<std::size_t>(scales.nearest() / profile.bin) + 1;
}

/// How far points of a surface may lie from it by noise and blur [m].
inline double heightTolerance(const FootProfile& profile) { return 8.0 * profile.noise + profile.blur; }

/// Whether a point's height fits a surface with the profile's slope that meets the shell at a level, as far as noise
/// and blur can tell.
inline bool fitsLevel(const FootPoint& p, double level, const FootProfile& profile) {
  return std::abs(p.z - level - profile.slope * p.d) <= heightTolerance(profile);
}

/// How far out a lip is seen; a crown may hide the rest of it, and its edge [m].
double seenTo(const FootProfile& lip);

/// Stacks the points of all stations, z relative to `datum` of their station, and finds the surface that meets the
/// shell: the line through the bins just outside the weld, extended both ways while bins lie on it.
FootProfile stackProfile(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
                         const FootScales& scales);

}  // namespace tank_datum
