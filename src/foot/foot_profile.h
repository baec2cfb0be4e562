#pragma once

#include <algorithm>
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
  double reach;        ///< how far out the section goes [m]
  double shell_noise;  ///< of points about the shell [m]
  double weld;         ///< the largest fillet weld to expect in the corner [m]

  /// Width over which an edge may be blurred [m].
  double blur() const { return 4.0 * shell_noise; }
  /// Where the foundation begins: beyond the weld and the shell's noise [m].
  double nearest() const { return std::max(weld, 3.0 * shell_noise); }
};

/// Stacks the points of all stations, z relative to `datum` of their station, and finds the surface that meets the
/// shell: the line through the bins just outside the weld, extended both ways while bins lie on it.
FootProfile stackProfile(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
                         const FootScales& scales);

}  // namespace tank_datum
