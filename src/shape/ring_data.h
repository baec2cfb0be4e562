#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The measured stations as a model of the ring takes them.
struct RingData {
  Eigen::VectorXd azimuths;    ///< as the user counts them [rad]
  Eigen::VectorXd directions;  ///< the same places as the scan has them, counter-clockwise from +x [rad]
  Eigen::VectorXd z;           ///< [m]
  Eigen::VectorXd sigmas;      ///< of each station's own error [m]; all the same when none is known
  Eigen::MatrixXd shared;      ///< [m x n] errors that stations share
  double usual_wave = 0.0;     ///< standard deviation of a coefficient of n = 2 before anything is seen [m]
  bool sigmas_known = false;   ///< false: from the stations' own residuals

  Eigen::Index count() const { return z.size(); }
};

/// @param radius      of the tank [m]
/// @param covariance  of all stations; empty: sigma_z each
RingData ringData(const std::vector<Station>& stations, double radius, const StationCovariance& covariance);

}  // namespace tank_datum
