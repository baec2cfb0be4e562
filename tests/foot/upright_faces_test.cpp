#include <gtest/gtest.h>

#include <vector>

#include "support/made_feet.h"

namespace tank_datum::upright_faces_test {

using namespace made_feet;

constexpr double kAt = 1.0;  // azimuth of what stands [rad]

/// Whether the ground at such a distance is left where points stand at such heights of the reach above it, 130 mm from
/// the shell.
bool isLeft(double d, const std::vector<double>& heights, double azimuth = kAt, double beside = 0.0) {
  MadeFoot made;
  made.add(azimuth + beside, d, 0.0);
  for (const double height : heights) made.add(azimuth, 0.13, height * kReach);
  FootRing ring = made.foot().ring;
  ring.leaveOutUprights(tankOfFoot(), kScales.nearest(), kReach);
  for (const FootPoint& p : ring.around(azimuth, 0.1, 0.0, 0.1)) {
    if (std::abs(p.d - d) < 1e-9) return true;
  }
  return false;
}

TEST(LeaveOutUprights, IsAFaceWithTheGroundWithinThreeCentimetresOrSix) {
  const std::vector<double> face = {0.3, 0.4, 0.7, 0.8};  // in cells of a fifteenth of the reach, from two on
  EXPECT_TRUE(isLeft(0.075, face));
  EXPECT_FALSE(isLeft(0.085, face));
  EXPECT_FALSE(isLeft(0.175, face));
  EXPECT_TRUE(isLeft(0.185, face));
}

TEST(LeaveOutUprights, TwoPointsInEachOfTwoLayersAreUpright) {
  EXPECT_FALSE(isLeft(0.13, {0.26, 0.6, 0.65, 0.99}));
  EXPECT_TRUE(isLeft(0.13, {0.26, 0.65, 0.99}));
  EXPECT_TRUE(isLeft(0.13, {0.26, 0.6, 0.65}));
  EXPECT_TRUE(isLeft(0.13, {0.35, 0.4, 0.55, 0.6})) << "one layer";
}

TEST(LeaveOutUprights, WhatIsLowOrFarAboveTheGroundIsNotUpright) {
  EXPECT_TRUE(isLeft(0.13, {0.2, 0.24, 0.65, 0.99}));
  EXPECT_TRUE(isLeft(0.13, {0.26, 0.6, 1.01, 1.05}));
}

TEST(LeaveOutUprights, GoesRoundTheRing) {
  EXPECT_FALSE(isLeft(0.13, {0.3, 0.4, 0.7, 0.8}, 0.0005, -0.001));
  EXPECT_TRUE(isLeft(0.13, {0.3, 0.4, 0.7, 0.8}, 0.0005, -0.008));
}

TEST(LeaveOutUprights, TheShellStays) {
  MadeFoot made;
  for (int i = 0; i < 40; ++i) made.add(kAt, 0.001 * (i % 40), 0.0125 * i);
  FootRing ring = made.foot().ring;
  ring.leaveOutUprights(tankOfFoot(), kScales.nearest(), kReach);
  EXPECT_EQ(ring.around(kAt, 0.1, 0.0, kReach).size(), 40U);
}

}  // namespace tank_datum::upright_faces_test
