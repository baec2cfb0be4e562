#pragma once

#include <Eigen/Core>
#include <string>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// The rotation that turns an axis of a scan's frame upwards: "x", "y", "z", "-x", "-y" or "-z".
/// @throws Error (Option) for any other name
inline Eigen::Matrix3d upRotation(const std::string& axis) {
  Eigen::Matrix3d r;
  if (axis == "z") {
    r << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  } else if (axis == "-z") {
    r << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  } else if (axis == "y") {
    r << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  } else if (axis == "-y") {
    r << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  } else if (axis == "x") {
    r << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  } else if (axis == "-x") {
    r << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  } else {
    throw Error(Error::Kind::Option, "options", "up", axis, "x, y, z, -x, -y or -z");
  }
  return r;
}

}  // namespace tank_datum
