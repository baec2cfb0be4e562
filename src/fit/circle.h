#pragma once

#include <vector>

#include "tank_datum/fit/curves.h"

namespace tank_datum {

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
