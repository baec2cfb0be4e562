#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// How far scans that were merged without labels disagree in height: the standard deviation of one of them [m], 0 where
/// nothing shows. Scans are told apart by the order of the points alone: those of one place that stand far apart in the
/// file were measured from different setups. They cannot be adjusted by that, since which pieces belong together is not
/// known, but what they disagree by is plain.
double mergedDisagreement(const Ring& ring, const Tank& tank, int threads = 0);

/// Shared errors of stations when every setup's height is off by so much: alike where one setup sees them, over about a
/// sixth of the ring. Rows of StationCovariance::factors: waves whose variances fall as exp(-n^2 L^2 / 2), with L half
/// a radian.
Eigen::MatrixXd mergedFactors(const std::vector<Station>& stations, double sigma);

}  // namespace tank_datum
