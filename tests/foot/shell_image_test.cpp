#include <gtest/gtest.h>

#include "foot/foot_candidates.h"

namespace tank_datum::shell_image_test {

constexpr FootScales kScales{0.3, 0.001, 0.013};

/// A floor at z = 0 and its shell, ten points a millimetre up to 0.3 m.
struct Wall {
  std::vector<FootPoint> points;

  Wall() {
    for (int i = 0; i < 564; ++i) points.push_back({0.0, 0.013 + 0.0005 * i, 0.0});
    add(3000, 0.0, 0.3);
  }
  /// So many points on the shell's circle, evenly between two heights.
  Wall& add(int count, double from, double to) {
    for (int i = 0; i < count; ++i) points.push_back({0.0, 0.0, from + (to - from) * (i + 0.5) / count});
    return *this;
  }
  /// How far below the floor its shell is seen [m].
  double seenBelow() const { return findCandidates(points, kScales, -0.3).front().over_foot; }
};

TEST(ShellImage, InAWetFloorIsNoShell) {
  EXPECT_NEAR(Wall().seenBelow(), 0.0, 0.002);
  EXPECT_NEAR(Wall().add(100, -0.3, 0.0).seenBelow(), 0.0, 0.002);
  EXPECT_NEAR(Wall().add(100, -0.2, 0.0).seenBelow(), 0.19, 0.01) << "far below any foot there is none of it";
}

TEST(ShellImage, HasFarFewerPointsThanTheShell) {  // a tenth, from 0.06 m above the bottom on
  EXPECT_NEAR(Wall().add(150, -0.3, 0.0).seenBelow(), 0.0, 0.002);
  EXPECT_NEAR(Wall().add(250, -0.3, 0.0).seenBelow(), 0.3, 0.02);
}

TEST(ShellImage, IsUpToTwiceAsDenseAsAtItsBottom) {
  EXPECT_NEAR(Wall().add(20, -0.3, -0.24).add(144, -0.24, 0.0).seenBelow(), 0.0, 0.003);
  EXPECT_NEAR(Wall().add(20, -0.3, -0.24).add(288, -0.24, 0.0).seenBelow(), 0.14, 0.03);
}

TEST(ShellImage, IsLookedForInTheLowestFifth) {
  EXPECT_NEAR(Wall().add(200, -0.268, 0.0).seenBelow(), 0.0, 0.003);
  EXPECT_NEAR(Wall().add(200, -0.2, 0.0).seenBelow(), 0.2, 0.01);
}

TEST(ShellImage, OfAFewPointsMayBeUnevenByChance) {
  EXPECT_NEAR(Wall().add(2, -0.3, -0.24).add(26, -0.24, 0.0).seenBelow(), 0.0, 0.005);
  EXPECT_GT(Wall().add(2, -0.3, -0.24).add(44, -0.24, 0.0).seenBelow(), 0.1);
}

}  // namespace tank_datum::shell_image_test
