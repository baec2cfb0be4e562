#include "locate/filled_wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/units.h"

namespace tank_datum::filled_wall_test {

constexpr double kVoxel = 0.1;  // [m]

/// A circle of points so far in, so high [m].
struct Behind {
  double in, z;
};

/// What a wall so high says of what lies behind it.
double shareOf(double height, const std::vector<Behind>& behind, double radius = 10.0) {
  Points points;
  const double step = 0.5 * kVoxel / radius;
  for (double a = 0.0; a < kTwoPi; a += step) {
    const auto add = [&](double in, double z) {
      points.emplace_back((radius - in) * std::cos(a), (radius - in) * std::sin(a), z);
    };
    for (double z = 0.0; z <= height; z += kVoxel) add(0.0, z);
    for (const Behind& b : behind) add(b.in, b.z);
  }
  Tank tank;
  tank.circle = {{0.0, 0.0}, radius};
  tank.rms = 0.002;
  tank.height = height;
  return shareFilled(points, kVoxel, tank);
}

TEST(ShareFilled, IsOfAPlanter) {
  EXPECT_EQ(shareOf(0.8, {{0.8, 0.7}, {1.0, 0.8}, {1.2, 0.9}}), 1.0);
  EXPECT_EQ(shareOf(0.8, {}), 0.0);
}

TEST(ShareFilled, IsOfSoilFartherInThanAShellUponARingwall) {
  EXPECT_EQ(shareOf(0.8, {{0.5, 0.8}, {0.5, 0.9}, {0.5, 1.0}}), 0.0);
}

TEST(ShareFilled, IsOfWallsLowerThanTanks) {
  EXPECT_EQ(shareOf(1.1, {{0.8, 1.0}}), 1.0);
  EXPECT_EQ(shareOf(1.3, {{0.8, 1.2}}), 0.0) << "a roof";
  EXPECT_EQ(shareOf(0.7, {{0.6, 0.7}}, 2.0), 1.0);
  EXPECT_EQ(shareOf(0.9, {{0.6, 0.9}}, 2.0), 0.0) << "a tin";
}

TEST(ShareFilled, IsNotOfStraysNorOfWhatAShellMirrors) {
  std::vector<Behind> strays;
  for (int i = 0; i < 20; ++i) strays.push_back({0.7 + 0.03 * i, 0.1 * i - 0.45});
  EXPECT_EQ(shareOf(0.8, strays), 0.0);
  EXPECT_EQ(shareOf(0.8, {{0.8, 0.0}, {1.0, 0.0}, {1.0, 0.8}}), 0.0);
}

/// One stray among many points of soil.
TEST(ShareFilled, IsOfSoilWithStrays) {
  std::vector<Behind> soil{{1.0, 0.2}};
  for (int i = 0; i < 12; ++i) soil.push_back({0.8 + 0.05 * i, 0.8});
  EXPECT_EQ(shareOf(0.8, soil), 1.0);
  soil.resize(8);
  EXPECT_EQ(shareOf(0.8, soil), 0.0);
}

TEST(ShareFilled, IsOfWhatLiesUpToHalfAWallAboveIt) {
  EXPECT_EQ(shareOf(0.8, {{0.8, 1.1}}), 1.0);
  EXPECT_EQ(shareOf(0.8, {{0.8, 1.3}}), 0.0) << "of another thing";
  EXPECT_EQ(shareOf(0.8, {{0.8, 0.3}}), 0.0) << "of what is seen through an opening";
}

}  // namespace tank_datum::filled_wall_test
