#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/setup_shares.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// How far scans that were merged without labels disagree in height, from the foundation alone: the standard deviation
/// of one of them [m], 0 where nothing shows. In arcs that two scans see, the foundation's points lie on two levels at
/// the same places; a step of the foundation itself parts them by place. Does not depend on the order of the points.
/// @param center  about which the stations stand [m]
double doubleDisagreement(const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                          const Eigen::Vector2d& center, const FoundationBand& band);

}  // namespace tank_datum
