#pragma once

#include <vector>

#include "foot/foot_state.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Gaps with z_refused where a shell could follow what was refused in them from the stations beside: it looks like
/// soil, but a heave of the foundation looks the same. The standard errors of their bridges hold it.
/// @param refused  what may be the datum nevertheless, at every station
std::vector<StationDatum> withRefusedDoubted(std::vector<StationDatum> stations,
                                             const std::vector<RefusedLevel>& refused, const Foot& foot);

/// Fits whose standard errors hold what may cover the foot: no more than they rise above those beside the arc, since
/// soil does not lie on a foot that goes straight on.
/// @param cover  how thick it may be at every station, else 0; empty: none anywhere [m]
std::vector<FootFit> withCoverDoubted(std::vector<FootFit> fits, const std::vector<double>& cover, const Foot& foot);

/// Fits whose standard errors hold another level too, at which their own elevations show the surface.
/// @param other  how far off it lies, either way, else 0 [m]
std::vector<FootFit> withLevelDoubted(std::vector<FootFit> fits, double other);

/// Fits whose standard errors hold by how much more a narrow surface falls up to its middle than lips do: wide beams
/// make such a slope of a lip and its edge together.
std::vector<FootFit> withFallDoubted(std::vector<FootFit> fits, const FootSections& sections, double reach);

/// Fits whose standard errors hold that what passes for a lip may lie beside the shell upon the foot.
std::vector<FootFit> withPipeDoubted(std::vector<FootFit> fits, const FootSections& sections, double reach);

}  // namespace tank_datum
