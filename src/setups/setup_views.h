#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/setup_adjustment.h"
#include "setups/setup_ring.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Compares the setups in every arc that two or more of them see: the foundation's elevations in bins of distance from
/// the shell, and the shell's radii in bins of height.
/// @param origins  of the setups, about which their motions turn
std::vector<ArcView> viewArcs(const SetupRing& ring, const Tank& tank, double reach,
                              const std::vector<Eigen::Vector3d>& origins, int threads);

}  // namespace tank_datum
