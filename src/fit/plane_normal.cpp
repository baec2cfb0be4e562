#include "fit/plane_normal.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace tank_datum {
namespace {

Eigen::Vector3d byAllEigenvectors(const SymmetricMatrix& m) {
  Eigen::Matrix3d full;
  full << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(full);  // computeDirect takes angles of the C library
  return solver.eigenvectors().col(0);
}

/// The smallest root of l^3 - l^2 + minors l - determinant, whose roots are not negative and have the sum 1: left of
/// it the cubic is concave and rises, so that Newton's steps from 0 come closer from the one side.
double smallestRoot(double minors, double determinant) {
  for (double root = 0.0;;) {
    const double value = ((root - 1.0) * root + minors) * root - determinant;
    const double slope = (3.0 * root - 2.0) * root + minors;
    if (!(slope > 0.0) || !(value < 0.0)) return root;
    const double next = root - value / slope;
    if (!(next - root > 1e-15)) return root;
    root = next;
  }
}

}  // namespace

Eigen::Vector3d planeNormal(const SymmetricMatrix& covariance) {
  constexpr double kFlat = 1e-4;  // the minors of a plane's points are 1/4 when it is as long as wide, of a line's 0
  const double trace = covariance.xx + covariance.yy + covariance.zz;
  if (!(trace > 0.0)) return byAllEigenvectors(covariance);
  const double scale = 1.0 / trace;
  const double xx = covariance.xx * scale, yy = covariance.yy * scale, zz = covariance.zz * scale;
  const double xy = covariance.xy * scale, xz = covariance.xz * scale, yz = covariance.yz * scale;
  const double minor_x = yy * zz - yz * yz, minor_y = xx * zz - xz * xz, minor_z = xx * yy - xy * xy;
  const double minors = minor_x + minor_y + minor_z;
  if (!(minors > kFlat)) return byAllEigenvectors(covariance);
  const double determinant = xx * minor_x - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy);
  const double root = smallestRoot(minors, determinant);
  const Eigen::Vector3d x(xx - root, xy, xz), y(xy, yy - root, yz), z(xz, yz, zz - root);
  // the rows lie in the plane across the eigenvector; of their products the longest is the surest
  Eigen::Vector3d normal = x.cross(y);
  double longest = normal.squaredNorm();
  for (const Eigen::Vector3d& other : {x.cross(z).eval(), y.cross(z).eval()}) {
    const double squared = other.squaredNorm();
    if (squared > longest) longest = squared, normal = other;
  }
  constexpr double kPlain = 1e-12;  // two smallest eigenvalues that are the same leave rows of one direction
  return longest > kPlain ? Eigen::Vector3d(normal / std::sqrt(longest)) : byAllEigenvectors(covariance);
}

}  // namespace tank_datum
