#pragma once

#include <Eigen/Core>

#include "core/portable_math.h"

namespace tank_datum::synth {

/// By an angle [rad] about a unit vector (Rodrigues); Eigen's takes the C library's sines, which differ by the
/// processor.
inline Eigen::Matrix3d rotation(double angle, const Eigen::Vector3d& axis) {
  const auto [sine, cosine] = portable::sinCos(angle);
  Eigen::Matrix3d cross;
  cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
  return cosine * Eigen::Matrix3d::Identity() + sine * cross + (1.0 - cosine) * axis * axis.transpose();
}

}  // namespace tank_datum::synth
