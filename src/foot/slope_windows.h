#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"
#include "foot/slanting_beams.h"

namespace tank_datum {

/// Fits of the slope in windows a few degrees wide, at every so many stations.
struct Slopes {
  std::size_t stride;
  std::vector<FootFit> fits;
  std::vector<double> steepness;         ///< tan of the rays' angle to the foundation; none where not looked at
  std::vector<double> pooled_steepness;  ///< the same of windows together, no flatter than they are
  double ring_steepness = 0;             ///< of all windows together
  std::vector<BeamEffects> effects;      ///< of the same, on a wide surface
  std::vector<BandPoints> bands;
};

/// The window that a station is nearest to, of so many at every so many stations.
inline std::size_t nearestWindow(std::size_t station, std::size_t stride, std::size_t windows) {
  return (station + stride / 2) / stride % windows;
}

/// The windows that slopes are fitted in, and what is known of a slope before.
struct SlopeWindows {
  std::size_t count;
  double half;         ///< of a window [rad]
  double sigma_slope;  ///< [m/m]
  bool beams;          ///< whether it is looked at how beams slant, and how points lie across the band
  double scatter = 0;  ///< of points about the surface: what single rows hide of it is no slope [m]
  std::vector<BeamEffects> effects = {};  ///< of beams, at each window; empty: none are known
};

/// The slopes that windows at equal steps show, of those where a surface was seen.
/// @param sigma_bend  of the datum's second-order term along the shell [1/m]
Slopes fitSlopes(const Foot& foot, const FootElevations& elevations, const FootSections& sections,
                 const SlopeWindows& windows, double sigma_bend);

/// What points scatter by about a surface, where many rows of the scan show it [m].
double scatterOf(const std::vector<FootFit>& fits);

}  // namespace tank_datum
