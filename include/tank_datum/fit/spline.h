#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

struct SplineOptions {
  int control_points = 0;  ///< 0 lets the data choose (Schwarz's criterion); else at least 4
  int check_every = 5;     ///< every n-th ordered point checks the curve and is not used in the fit
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const SplineOptions& options);

/// The four uniform cubic B-spline basis functions at t in [0, 1] (the paper's G0..G3; its G1 is printed with -3t^3 and
/// must have +3t^3: the four sum to 1).
Eigen::Vector4d cubicBasis(double t);

/// A closed uniform cubic B-spline over one turn of azimuth.
struct ClosedSpline {
  Eigen::MatrixX3d control_points;                                 ///< [m]; empty until fitted
  double rms = std::numeric_limits<double>::quiet_NaN();           ///< of the check points' distances to the curve [m]
  double max_residual = std::numeric_limits<double>::quiet_NaN();  ///< the largest of them [m]
  std::size_t check_points = 0;

  bool valid() const { return control_points.rows() >= 4; }
  /// The curve at the parameter azimuth / 2 pi, any real azimuth [rad].
  Eigen::Vector3d at(double azimuth) const;
  /// Distance of a point to the curve, searched around the given azimuth [m].
  double distance(const Eigen::Vector3d& point, double azimuth) const;
};

/// Step 5 of the method: the least-squares curve, not an interpolation of noise. Where a stretch of the curve has no
/// points, the smallest second differences of the control points bridge it.
/// @param points    in order round the tank [m]
/// @param azimuths  of the points about the tank's centre, ascending, in [0, 2 pi) [rad]
/// @return not valid for fewer than 12 points
ClosedSpline fitClosedSpline(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& azimuths,
                             const SplineOptions& options);

}  // namespace tank_datum
