#pragma once

#include <Eigen/Core>

namespace tank_datum {

struct SymmetricMatrix {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

/// The eigenvector of the smallest eigenvalue of a covariance, of unit length. Where points lie on a line or in one
/// place, any direction across it.
Eigen::Vector3d planeNormal(const SymmetricMatrix& covariance);

}  // namespace tank_datum
