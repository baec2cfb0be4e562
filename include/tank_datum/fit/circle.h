#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

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

/// The circle through three points; invalid when they are collinear.
Circle circleThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Geometric least squares (Gauss-Newton on |p - c| - r), starting from `start`.
/// @param weights  one per point, or empty for 1
/// @return invalid when the points do not determine a circle
Circle fitCircle(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights, const Circle& start);

/// Iteratively reweighted fit with Tukey's biweight (c = 4.685) on the residuals' MAD, starting from `start`.
/// @return invalid when the points do not determine a circle
Circle fitCircleRobust(const std::vector<Eigen::Vector2d>& points, const Circle& start);

/// A first circle when nothing is known: the best of seeded three-point samples by the number of points within
/// `tolerance` [m] (RANSAC, Fischler and Bolles 1981), then fitCircleRobust on those points.
Circle findCircle(const std::vector<Eigen::Vector2d>& points, double tolerance);

}  // namespace tank_datum
