#include "io/point_extent.h"

#include <gtest/gtest.h>

namespace tank_datum::point_extent_test {

/// Points at every centimetre of a line of so many metres.
Points line(int metres) {
  Points points;
  for (int i = 0; i <= 100 * metres; ++i) points.emplace_back(0.01 * i, 5.0, -2.0);
  return points;
}

TEST(Extent, ReachesFromTheMiddleAsFarAsTwoInFivePointsDo) {
  const Extent extent = extentOf(line(10));
  EXPECT_NEAR((extent.middle - Eigen::Vector3d(5.0, 5.0, -2.0)).norm(), 0.0, 0.011);
  EXPECT_NEAR(extent.reach, 2.0, 0.011);
}

TEST(Extent, OfManyPointsIsThatOfEveryNth) {
  const Extent extent = extentOf(line(1000));
  EXPECT_NEAR(extent.middle.x(), 500.0, 0.1);
  EXPECT_NEAR(extent.reach, 200.0, 0.1);
}

TEST(Extent, WhatIsFiveHundredTimesAsFarAwayIsOfNoScan) {
  Extent extent;
  extent.middle = {1.0, 2.0, 3.0};
  extent.reach = 2.0;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(extent.holds({1.0, 2.0 + side * 990.0, 3.0}));
    EXPECT_FALSE(extent.holds({1.0, 2.0, 3.0 + side * 1010.0}));
  }
}

}  // namespace tank_datum::point_extent_test
