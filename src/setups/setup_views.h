#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/setup_adjustment.h"
#include "setups/setup_ring.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Where an arc's points are looked for: as far off from where they are thought to be, and how far off each setup is
/// thought to be.
struct ViewScope {
  double window = 0.08;              ///< what lies further off its bin's densest place is something else [reach]
  std::size_t most_of_arc = 60'000;  ///< points; of more every n-th is taken
  std::vector<SetupMotion> shifts;   ///< of each setup; none known where empty
};

/// Compares the setups in every arc that two or more of them see: the foundation's elevations in bins of distance from
/// the shell, and the shell's radii in bins of height.
/// @param origins  of the setups, about which their motions turn
/// @return offsets of the points as they were given, with the setups' shifts
std::vector<ArcView> viewArcs(const SetupRing& ring, const Tank& tank, double reach,
                              const std::vector<Eigen::Vector3d>& origins, const ViewScope& scope, int threads);

}  // namespace tank_datum
