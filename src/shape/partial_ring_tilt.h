#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// A tilt plane with what a gap leaves unknown of it.
struct PlaneFit {
  Eigen::Vector3d plane;       ///< elevation at the centre [m], slopes along x and y [m/m]
  Eigen::Matrix3d covariance;  ///< of these
};

/// Whether the measured stations leave a gap, wider than their usual spacing, through which waves of the datum pass for
/// tilt.
bool hasTiltingGap(const std::vector<Station>& stations);

/// The plane beside waves of two to four lobes, which all round are orthogonal to it, but not along an arc. What the
/// arc does not tell of the waves is left to what tanks do: their amplitudes are about R / 2000 for two lobes and fall
/// with the square of the number (Bayesian least squares). So an arc too short to tell them apart has a wide standard
/// error.
/// @param center  of the tank [m]
PlaneFit fitPlaneBesideWaves(const std::vector<Station>& stations, const Eigen::Vector2d& center);

}  // namespace tank_datum
