#include "fit/plane_normal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace tank_datum::plane_normal_test {

SymmetricMatrix partsOf(const Eigen::Matrix3d& m) { return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)}; }

/// A covariance with these standard deviations along three directions at random, and the first of the directions.
Eigen::Matrix3d covariance(const Eigen::Vector3d& sigmas, std::mt19937& random, Eigen::Vector3d& normal) {
  std::normal_distribution<double> any;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
  const Eigen::Matrix3d axes = turn.toRotationMatrix();
  normal = axes.col(0);
  return axes * sigmas.cwiseAbs2().asDiagonal() * axes.transpose();
}

TEST(PlaneNormal, IsTheDirectionOfTheLeastSpread) {
  std::mt19937 random(1);
  Eigen::Vector3d truth;
  for (const double thickness : {0.0, 1e-6, 0.01, 0.3, 0.9}) {
    for (const double width : {0.02, 0.2, 1.0}) {
      for (const double scale : {1e-4, 1.0, 1e3}) {
        const Eigen::Vector3d sigmas = scale * Eigen::Vector3d(thickness * width, width, 1.0);
        const Eigen::Vector3d found = planeNormal(partsOf(covariance(sigmas, random, truth)));
        EXPECT_NEAR(found.norm(), 1.0, 1e-12);
        EXPECT_LT(found.cross(truth).norm(), 1e-8 / (width * width)) << thickness << " " << width << " " << scale;
      }
    }
  }
}

TEST(PlaneNormal, AgreesWithTheIterativeSolver) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> spread(0.1, 1.0);
  for (int i = 0; i < 1000; ++i) {
    Eigen::Vector3d ignored;
    const Eigen::Vector3d sigmas(spread(random), spread(random), spread(random));
    const Eigen::Matrix3d matrix = covariance(sigmas, random, ignored);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    const double apart = (solver.eigenvalues()[1] - solver.eigenvalues()[0]) / matrix.trace();
    const Eigen::Vector3d found = planeNormal(partsOf(matrix));
    EXPECT_LT(found.cross(solver.eigenvectors().col(0)).norm(), 1e-12 / (apart * apart)) << sigmas.transpose();
  }
}

TEST(PlaneNormal, OfALineLiesAcrossIt) {
  std::mt19937 random(3);
  Eigen::Vector3d along;
  const Eigen::Matrix3d matrix = covariance({1.0, 0.0, 0.0}, random, along);
  const Eigen::Vector3d found = planeNormal(partsOf(matrix));
  EXPECT_NEAR(found.norm(), 1.0, 1e-12);
  EXPECT_NEAR(found.dot(along), 0.0, 1e-7);
}

TEST(PlaneNormal, OfABallOrASinglePlaceIsSomeDirection) {
  EXPECT_NEAR(planeNormal({2.0, 0.0, 0.0, 2.0, 0.0, 2.0}).norm(), 1.0, 1e-12);
  EXPECT_NEAR(planeNormal({}).norm(), 1.0, 1e-12);
}

}  // namespace tank_datum::plane_normal_test
