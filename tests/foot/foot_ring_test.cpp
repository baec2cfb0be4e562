#include <gtest/gtest.h>

#include <cmath>

#include "foot/foot_fit.h"
#include "support/made_clouds.h"

namespace tank_datum::foot_ring_test {

using made_clouds::kTurn;

/// A shell of 10 m radius and points at given azimuth, distance outside and elevation.
struct RingOf {
  ShellModel shell{std::vector<ShellLine>(360, line()), 0.0};
  Points points;

  static ShellLine line() {
    ShellLine one;
    one.radius = 10.0;
    one.points = 1;
    return one;
  }
  RingOf& add(double azimuth, double off, double z) {
    points.emplace_back((10.0 + off) * std::cos(azimuth), (10.0 + off) * std::sin(azimuth), z);
    return *this;
  }
  FootRing ring(double side = 1.0, double reach = 0.5) const { return {PolarRing(points, {0, 0}), shell, side, reach}; }
};

TEST(FootRing, SeesArcDistanceAndElevation) {
  const auto points = RingOf().add(1.02, 0.2, 3.0).ring().around(1.0, 0.05, 3.1, 0.5);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0].t, 0.2, 1e-9);
  EXPECT_NEAR(points[0].d, 0.2, 1e-9);
  EXPECT_NEAR(points[0].z, 3.0, 1e-12);
}

TEST(FootRing, LooksOutwardsOrInwards) {
  RingOf both;
  both.add(1.0, 0.2, 3.0).add(1.0, -0.3, 3.0);
  ASSERT_EQ(both.ring(1.0).around(1.0, 0.05, 3.0, 0.5).size(), 1U);
  EXPECT_NEAR(both.ring(1.0).around(1.0, 0.05, 3.0, 0.5)[0].d, 0.2, 1e-9);
  ASSERT_EQ(both.ring(-1.0).around(1.0, 0.05, 3.0, 0.5).size(), 1U);
  EXPECT_NEAR(both.ring(-1.0).around(1.0, 0.05, 3.0, 0.5)[0].d, 0.3, 1e-9);
}

TEST(FootRing, EndsAtTheReachTheWindowAndTheHeight) {
  RingOf ring;
  ring.add(1.0, 0.4, 3.0).add(1.04, 0.1, 3.0).add(1.0, 0.1, 3.3).add(1.0, -0.01, 3.0);
  EXPECT_EQ(ring.ring().around(1.0, 0.05, 3.0, 0.5).size(), 4U);
  EXPECT_EQ(ring.ring(1.0, 0.3).around(1.0, 0.05, 3.0, 0.5).size(), 3U);
  EXPECT_EQ(ring.ring().around(1.0, 0.03, 3.0, 0.5).size(), 3U);
  EXPECT_EQ(ring.ring().around(1.0, 0.05, 3.0, 0.2).size(), 3U);
}

TEST(FootRing, WindowsGoRoundTheSeam) {
  RingOf ring;
  ring.add(0.02, 0.1, 3.0).add(-0.02, 0.1, 3.0);
  for (const double azimuth : {0.0, kTurn - 0.01, 0.01}) {
    const auto points = ring.ring().around(azimuth, 0.05, 3.0, 0.5);
    ASSERT_EQ(points.size(), 2U) << azimuth;
    EXPECT_NEAR(std::abs(points[0].t - points[1].t), 0.4, 1e-9);
  }
}

TEST(FootRing, LeavesOutWhereTheShellIsUnknown) {
  RingOf ring;
  ring.shell = ShellModel(std::vector<ShellLine>(360), 0.0);
  EXPECT_TRUE(ring.add(1.0, 0.1, 3.0).ring().around(1.0, 0.1, 3.0, 0.5).empty());
}

}  // namespace tank_datum::foot_ring_test
