#pragma once

#include <Eigen/Core>

#include "core/portable_math.h"

namespace tank_datum {

/// What the coefficients of a plane over the ring are multiplied by at an azimuth [rad]: its mean level, and by how
/// much it is higher in +x and in +y.
inline Eigen::Vector3d planeRow(double azimuth) { return {1.0, portable::cos(azimuth), portable::sin(azimuth)}; }

}  // namespace tank_datum
