#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// A vertical column of a scan that is filled over a stretch of height: a piece of wall seen from above.
struct WallCell {
  Eigen::Vector2d position;    ///< mean of the column's points [m]
  Eigen::Vector2d normal;      ///< unit, across the wall, sign undefined
  double bottom = 0, top = 0;  ///< ends of the longest unbroken stretch [m]
};

/// The walls of a voxel sample: columns of two voxels' width whose longest vertical stretch without a hole is at least
/// four voxels high and whose neighbours line up in plan.
/// @param points  the sample's points [m]
/// @param voxel   its spacing [m]
std::vector<WallCell> mapWalls(const Points& points, double voxel);

}  // namespace tank_datum
