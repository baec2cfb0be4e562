#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::refused_levels_test {

using namespace made_feet;

/// What may be the datum nevertheless at a station that alone shows a surface so high, which slopes outwards.
double refusedAt50(double height, double slope, bool shell_below = false) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s >= 49 && s <= 51) continue;
    made.addStation(s, 40, 0.02, 0.28, [](double) { return 0.0; });
  }
  for (int s = 49; s <= 51; ++s) made.addStation(s, 40, 0.02, 0.28, [&](double d) { return height + slope * d; });
  for (int i = 0; shell_below && i < 40; ++i)
    made.add((50 - 0.4 + 0.02 * i) * made.step(), 0.0, height - 0.005 - 0.0003 * i);
  Foot& foot = made.foot();
  return findOutliers(foot, levelPass(4.0 * foot.half_step, 0.3)).refused[50].z;
}

TEST(FindOutliers, ASurfaceFarOffThatMayBeTheFoundationMayBeTheDatum) {
  EXPECT_NEAR(refusedAt50(0.060, 0.0), 0.060, 1e-4);
  EXPECT_NEAR(refusedAt50(-0.060, 0.0), -0.060, 1e-4);
}

TEST(FindOutliers, ASurfaceFarOffThatIsNoFoundationIsNot) {
  EXPECT_TRUE(std::isnan(refusedAt50(0.060, -0.1))) << "a heap";
  EXPECT_TRUE(std::isnan(refusedAt50(0.060, 0.2))) << "rises outwards";
  EXPECT_TRUE(std::isnan(refusedAt50(0.060, 0.0, true))) << "the shell goes on below";
}

}  // namespace tank_datum::refused_levels_test
