#include "locate/circle_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::circle_search_test {

constexpr double kVoxel = 0.05;

WallCell wallAt(const Eigen::Vector2d& position, double normal) {
  WallCell wall;
  wall.position = position;
  wall.normal = {std::cos(normal), std::sin(normal)};
  wall.top = 5.0;
  return wall;
}

/// Walls all round a circle, a sixth of the turn bulged outwards; their normals turned off the direction to the centre.
std::vector<WallCell> wallsOf(const Circle& circle, double bulge = 0.0, double turned = 0.0) {
  std::vector<WallCell> walls;
  const int count = static_cast<int>(kTwoPi * circle.radius / (3.0 * kVoxel));
  for (int i = 0; i < count; ++i) {
    const double azimuth = kTwoPi * (i + 0.5) / count, radius = circle.radius + (6 * i < count ? bulge : 0.0);
    const Eigen::Vector2d outwards(std::cos(azimuth), std::sin(azimuth));
    walls.push_back(wallAt(circle.center + radius * outwards, azimuth + turned));
  }
  return walls;
}

/// The longest arc seen; 0 where no circle is found.
double arcOf(const std::vector<WallCell>& walls) {
  const auto circles = findWallCircles(walls, kVoxel, {});
  return circles.empty() ? 0.0 : circles.front().coverage;
}

TEST(FindWallCircles, WallsFaceTheCentreWithinTwentyDegrees) {
  const Circle circle{{1.0, -2.0}, 6.0};
  EXPECT_EQ(arcOf(wallsOf(circle, 0.0, toRadians(18.0))), kTwoPi);
  EXPECT_EQ(arcOf(wallsOf(circle, 0.0, toRadians(22.0))), 0.0);
  EXPECT_EQ(arcOf(wallsOf(circle, 0.0, toRadians(55.0))), 0.0);
}

TEST(FindWallCircles, AShellMayBeOutOfRoundByOnePercentOfItsRadius) {
  const Circle circle{{1.0, -2.0}, 20.0};  // by 0.2 m, and a voxel
  EXPECT_EQ(arcOf(wallsOf(circle, 0.24)), kTwoPi);
  EXPECT_NEAR(arcOf(wallsOf(circle, 0.26)), kTwoPi * 5.0 / 6.0, 0.1);
}

TEST(FindWallCircles, FortyAtMostAreLookedFor) {
  std::vector<WallCell> walls;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 7; ++column) {
      for (const WallCell& wall : wallsOf({{10.0 * column, 10.0 * row}, 2.5})) walls.push_back(wall);
    }
  }
  EXPECT_EQ(findWallCircles(walls, kVoxel, {}).size(), 40U);
}

}  // namespace tank_datum::circle_search_test
