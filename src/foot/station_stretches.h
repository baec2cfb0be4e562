#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// Neighbouring stations whose points are fitted together, at one of them.
struct StationStretch {
  std::size_t first, count;
  std::size_t at;  ///< the station nearest to the points' middle that may be fitted

  /// How far that station stands beside the middle of the stretch, in stations.
  double besideMiddle() const { return static_cast<double>(at - first) - 0.5 * static_cast<double>(count - 1); }
};

/// Stretches of one station where it has points enough, else of a few neighbours; none that begins or ends without
/// points. A level is known best where most points are: beside it, it leans on a slope that few points tell.
/// @param counts   points on the surface at each station
/// @param fitted   stations that a stretch may be fitted at; where a stretch has none it is in its middle
/// @param longest  stations of a stretch
std::vector<StationStretch> stretchesOf(const std::vector<std::size_t>& counts, const std::vector<bool>& fitted,
                                        std::size_t longest);

}  // namespace tank_datum
