#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A horizontal circle [m]; NaN until fitted.
struct Circle {
  Eigen::Vector2d center = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  double radius = std::numeric_limits<double>::quiet_NaN();

  bool valid() const { return radius > 0.0 && center.allFinite(); }
  /// Distance from the circle, positive outside [m].
  double residual(const Eigen::Vector2d& p) const { return (p - center).norm() - radius; }
};

/// A periodic function a0 + sum over n of a_n cos(n t) + b_n sin(n t); empty until fitted.
struct PeriodicFit {
  Eigen::VectorXd coefficients;  ///< a0, a1, b1, a2, b2, ...
  Eigen::MatrixXd covariance;    ///< of the coefficients, from the weights as given
  double sigma = 0.0;            ///< robust standard deviation of the residuals

  bool valid() const { return coefficients.size() > 0; }
  int order() const { return static_cast<int>(coefficients.size() / 2); }
  double operator()(double azimuth) const;
};

struct SplineOptions {
  int control_points = 0;  ///< 0 lets the data choose (Schwarz's criterion); else at least 4
  int check_every = 5;     ///< every n-th ordered point checks the curve and is not used in the fit
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const SplineOptions& options);

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

}  // namespace tank_datum
