#include "core/azimuth.h"

#include <gtest/gtest.h>

namespace tank_datum::azimuth_test {

TEST(WithinTurn, IsFromZeroToAFullTurn) {
  EXPECT_EQ(withinTurn(0.0), 0.0);
  EXPECT_EQ(withinTurn(kTwoPi), 0.0);
  EXPECT_NEAR(withinTurn(-0.25 * kTwoPi), 0.75 * kTwoPi, 1e-12);
  EXPECT_NEAR(withinTurn(2.5 * kTwoPi), 0.5 * kTwoPi, 1e-12);
}

TEST(AzimuthOfArm, IsCountedCounterClockwiseFromX) {
  EXPECT_EQ(azimuthOfArm(1.0, 0.0), 0.0);
  EXPECT_NEAR(azimuthOfArm(0.0, 2.0), 0.25 * kTwoPi, 1e-12);
  EXPECT_NEAR(azimuthOfArm(1.0, -1.0), 0.875 * kTwoPi, 1e-12);
}

TEST(AzimuthOfArm, IsLessThanAFullTurn) {
  EXPECT_LT(azimuthOfArm(1.0, -1e-300), kTwoPi);
  EXPECT_GT(azimuthOfArm(1.0, -1e-300), 6.28);
}

TEST(WidestArc, LiesBetweenNeighboursRoundTheTurn) {
  EXPECT_DOUBLE_EQ(widestArc({3.0, 0.5, 1.0}), 0.5 + kTwoPi - 3.0);
  EXPECT_DOUBLE_EQ(widestArc({0.1, 4.0, 6.0}), 3.9);
  EXPECT_DOUBLE_EQ(widestArc({1.0}), kTwoPi);
  EXPECT_DOUBLE_EQ(widestArc({}), kTwoPi);
}

}  // namespace tank_datum::azimuth_test
