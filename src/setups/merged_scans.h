#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/setup_shares.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/setups/setups.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Standard deviation of the height of one of several scans that nothing tells apart [m]; 0 of one scan. Scans are
/// several where they are seen to disagree, and where more of a shell is seen from outside than one setup sees.
/// @param discrepancy  what two of them are seen to disagree by [m], each pair of neighbours telling of one difference;
///                     0 where nothing shows, which tells nothing: less than their noise is not seen
/// @param given        SetupOptions::error [m]; 0 for what is usual, 2 mm and 10 arc-seconds over 20 m, and
///                     as uncertain as that is
/// @param noise        of the foundation's points, in which what they disagree by may hide [m]
double mergedSigma(const Ring& ring, const Tank& tank, double discrepancy, double given, double noise);

/// What scans merged without labels disagree by, where the stations' foundation shows it too, and what follows of it.
/// @param center  about which the stations stand [m]
void judgeMerged(SetupAgreement& agreement, const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                 const Eigen::Vector2d& center, const FoundationBand& band);

/// Shared errors of stations when every setup's height is off by so much: alike where one setup sees them, over about a
/// sixth of the ring. Rows of StationCovariance::factors: waves whose variances fall as exp(-n^2 L^2 / 2), with L half
/// a radian.
Eigen::MatrixXd mergedFactors(const std::vector<Station>& stations, double sigma);

}  // namespace tank_datum
