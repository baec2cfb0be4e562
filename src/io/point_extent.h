#pragma once

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// The middle of points and how far they reach from it, of which two in five may say what they like.
struct Extent {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< median along each axis [m]
  double reach = 0.0;  ///< from the middle, along the axis where it is most: of two in five of the points at most [m]

  /// Whether a point can belong to the same scan: a scanner that has two in five of its points within metres of their
  /// middle sees nothing hundreds of times as far away.
  bool holds(const Eigen::Vector3d& point) const;
};

/// @param points  at least one
Extent extentOf(const Points& points);

}  // namespace tank_datum
