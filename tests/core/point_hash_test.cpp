#include "core/point_hash.h"

#include <gtest/gtest.h>

#include <set>

namespace tank_datum::point_hash_test {

/// Another frame moves a coordinate by its rounding, two rows of a scan by more.
TEST(PointHash, IsOfStepsOfAHundredthOfAMillimetre) {
  const Eigen::Vector3d point(12.5, -3.25, 0.75);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Eigen::Vector3d near = point, apart = point;
      near[axis] += side * 4e-6;
      apart[axis] += side * 6e-6;
      EXPECT_EQ(pointHash(near), pointHash(point)) << axis;
      EXPECT_NE(pointHash(apart), pointHash(point)) << axis;
    }
  }
}

/// What is beyond 63 bits has the hash of the last step, whichever processor counts.
TEST(PointHash, OfDamagedFloatsIsThatOfTheLastStep) {
  EXPECT_EQ(pointHash({1e300, 0, 0}), pointHash({9e13, 0, 0}));
  EXPECT_EQ(pointHash({0, -1e300, 0}), pointHash({0, -9e13, 0}));
  EXPECT_NE(pointHash({8e13, 0, 0}), pointHash({9e13, 0, 0}));
}

TEST(PointHash, OfAGridHardlyMeet) {
  std::set<std::uint32_t> hashes;
  for (int i = 0; i < 10'000; ++i) hashes.insert(pointHash({0.01 * (i % 100), 0.01 * (i / 100), 0.0}));
  EXPECT_GT(hashes.size(), 9'995U);  // of 2^32, one pair meets by chance once in a hundred times
}

}  // namespace tank_datum::point_hash_test
