#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/fit/curves.h"

namespace tank_datum {

/// The four uniform cubic B-spline basis functions at t in [0, 1] (the paper's G0..G3; its G1 is printed with -3t^3 and
/// must have +3t^3: the four sum to 1).
Eigen::Vector4d cubicBasis(double t);

/// Step 5 of the method: the least-squares curve, not an interpolation of noise. Where a stretch of the curve has no
/// points, the smallest second differences of the control points bridge it.
/// @param points    in order round the tank [m]
/// @param azimuths  of the points about the tank's centre, ascending, in [0, 2 pi) [rad]
/// @return not valid for fewer than 12 points
ClosedSpline fitClosedSpline(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& azimuths,
                             const SplineOptions& options);

}  // namespace tank_datum
