#include "locate/walls_behind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::walls_behind_test {

constexpr double kRadius = 10.0;

Tank tankOf(Side side) {
  Tank tank;
  tank.circle = {{3.0, 4.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  tank.height = 8.0;
  tank.resolution = 0.1;
  tank.side = side;
  return tank;
}

/// Walls on a circle about the same centre over an arc, three to a sector; their normals turned off the radius.
void addArc(std::vector<WallCell>& walls, double radius, double arc, double top = 8.0, double turned = 0.0) {
  for (double a = 0.01; a < arc; a += kTwoPi / 216.0) {
    WallCell wall;
    wall.normal = {std::cos(a + turned), std::sin(a + turned)};
    wall.position = Eigen::Vector2d(3.0, 4.0) + radius * Eigen::Vector2d(std::cos(a), std::sin(a));
    wall.top = top;
    walls.push_back(wall);
  }
}

TEST(WallsBehind, NoneBehindAShell) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi);
  addArc(walls, 0.9 * kRadius, kTwoPi);  // a mug's inner wall
  addArc(walls, 1.5 * kRadius, kTwoPi);  // in front of it
  EXPECT_EQ(wallsBehind(walls, tankOf(Side::Outside)).share, 0.0);
  EXPECT_EQ(wallsBehind({}, tankOf(Side::Outside)).share, 0.0);
}

TEST(WallsBehind, ShareAndDistance) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi / 2);
  addArc(walls, 0.7 * kRadius, kTwoPi / 8);
  const WallsBehind behind = wallsBehind(walls, tankOf(Side::Outside));
  EXPECT_NEAR(behind.share, 0.25, 1e-9);
  EXPECT_NEAR(behind.distance, 0.3 * kRadius, 1e-9);
}

TEST(WallsBehind, BehindAnInnerWallIsOutsideAndNear) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi);
  addArc(walls, 1.5 * kRadius, kTwoPi / 2);
  addArc(walls, 2.5 * kRadius, kTwoPi);  // the next tank
  const WallsBehind behind = wallsBehind(walls, tankOf(Side::Inside));
  EXPECT_NEAR(behind.share, 0.5, 1e-9);
  EXPECT_NEAR(behind.distance, 0.5 * kRadius, 1e-9);
}

TEST(WallsBehind, OnlyAtHeightsOfTheShell) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi);
  addArc(walls, 0.5 * kRadius, kTwoPi, 0.2);  // less than three spacings high
  EXPECT_EQ(wallsBehind(walls, tankOf(Side::Outside)).share, 0.0);
}

/// The share of the azimuths of a shell behind which walls stand at this radius.
double shareBehind(double radius) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi);
  addArc(walls, radius, kTwoPi);
  return wallsBehind(walls, tankOf(Side::Outside)).share;
}

TEST(WallsBehind, AreAFifthOfTheRadiusBehindTheShell) {
  EXPECT_EQ(shareBehind(0.82 * kRadius), 0.0);
  EXPECT_EQ(shareBehind(0.78 * kRadius), 1.0);
}

/// The share of a turn of walls in front of others that are the shell, when one half of them is it for certain.
double shareOfShell(double off, double turned) {
  std::vector<WallCell> walls;
  addArc(walls, kRadius, kTwoPi / 2);
  addArc(walls, kRadius + off, kTwoPi, 8.0, turned);
  addArc(walls, 0.5 * kRadius, kTwoPi / 2);
  return 0.5 / wallsBehind(walls, tankOf(Side::Outside)).share;
}

TEST(WallsBehind, TheShellIsWithinTwoPercentOfItsRadiusAndFacesItsCentre) {
  EXPECT_NEAR(shareOfShell(0.28, 0.0), 1.0, 1e-9);  // a spacing of 0.1 m beside
  EXPECT_NEAR(shareOfShell(0.32, 0.0), 0.5, 1e-9);
  EXPECT_NEAR(shareOfShell(0.0, toRadians(19.0)), 1.0, 1e-9);
  EXPECT_NEAR(shareOfShell(0.0, toRadians(21.0)), 0.5, 1e-9);
}

TEST(WallsBehind, OneColumnMayBeAPoleAndTwoAreAWall) {
  std::vector<WallCell> walls, pole;
  addArc(walls, kRadius, kTwoPi);
  addArc(pole, 0.5 * kRadius, 0.02);
  ASSERT_EQ(pole.size(), 1U);
  walls.push_back(pole[0]);
  EXPECT_EQ(wallsBehind(walls, tankOf(Side::Outside)).share, 0.0);
  walls.push_back(pole[0]);
  EXPECT_NEAR(wallsBehind(walls, tankOf(Side::Outside)).share, 1.0 / 72.0, 1e-12);
}

}  // namespace tank_datum::walls_behind_test
