#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// A tilt plane with what a gap leaves unknown of it.
struct PlaneFit {
  Eigen::Vector3d plane;       ///< elevation at the centre [m], slopes along x and y [m/m]
  Eigen::Matrix3d covariance;  ///< of these
  double freedom = 0.0;        ///< degrees of freedom behind the covariance's scale; 0: errors were given
};

/// Whether the measured stations leave a gap, wider than their usual spacing, through which waves of the datum pass for
/// tilt.
bool hasTiltingGap(const std::vector<Station>& stations);

/// The plane that a model of the ring sees beside its waves; or of at most 64 stations without such a gap the plane of
/// least squares, as the codes want it, with the model's word on how far it is from the truth: errors of stations and
/// what waves leave in it where stations are not equally spaced.
/// @param center  of the tank [m]
PlaneFit fitPlane(const std::vector<Station>& stations, const Eigen::Vector2d& center,
                  const StationCovariance& covariance);

}  // namespace tank_datum
