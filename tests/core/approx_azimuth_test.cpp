#include "core/approx_azimuth.h"

#include <gtest/gtest.h>

namespace tank_datum::approx_azimuth_test {

TEST(QuickTurn, IsTheDirectionAsAShareOfATurn) {
  for (int i = 0; i < 100'000; ++i) {
    const double turn = i / 1e5, size = 0.001 + i;
    const double found = approxTurn(size * std::cos(kTwoPi * turn), size * std::sin(kTwoPi * turn));
    EXPECT_GE(found, 0.0);
    EXPECT_LT(found, 1.0);
    EXPECT_LT(std::abs(std::remainder(found - turn, 1.0)) * kTwoPi, 1.2e-5) << turn;
  }
}

TEST(QuickTurn, OfTheAxesIsExactAndOfTheCentreIsNone) {
  EXPECT_EQ(approxTurn(2, 0), 0.0);
  EXPECT_EQ(approxTurn(0, 2), 0.25);
  EXPECT_EQ(approxTurn(-2, 0), 0.5);
  EXPECT_EQ(approxTurn(0, -2), 0.75);
  EXPECT_EQ(approxTurn(0, 0), 0.0);
}

TEST(QuickTurn, NeverReachesAWholeTurn) { EXPECT_EQ(approxTurn(1.0, -1e-300), 0.0); }

}  // namespace tank_datum::approx_azimuth_test
