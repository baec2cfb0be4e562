#include "locate/wall_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_clouds.h"

namespace tank_datum::wall_map_test {

using made_clouds::kTurn;
using made_clouds::uniform;

constexpr double kVoxel = 0.1;

/// A point in every voxel of an upright face over x from 0 to `length`, from z = low to high.
Points wall(double length, double low, double high, double y = 0.03) {
  Points points;
  for (double x = 0.05; x < length; x += kVoxel) {
    for (double z = low; z <= high + 1e-9; z += kVoxel) points.emplace_back(x, y, z);
  }
  return points;
}

/// A surface over a square of `size`, a point per voxel.
template <typename Height>
Points surface(double size, Height&& height) {
  Points points;
  for (double x = 0.05; x < size; x += kVoxel) {
    for (double y = 0.05; y < size; y += kVoxel) points.emplace_back(x, y, height(x, y));
  }
  return points;
}

TEST(MapWalls, OfAnUprightFaceAreCellsAcrossWhichItsNormalPoints) {
  const auto walls = mapWalls(wall(4.0, 1.0, 3.0), kVoxel);
  ASSERT_EQ(walls.size(), 20U);  // columns of two voxels
  for (const WallCell& cell : walls) {
    EXPECT_NEAR(std::abs(cell.normal.y()), 1.0, 1e-12);
    EXPECT_NEAR(cell.bottom, 1.0, 1e-9);
    EXPECT_NEAR(cell.top, 3.0, 1e-9);
    EXPECT_NEAR(cell.position.y(), 0.03, 1e-12);
    EXPECT_NEAR(std::remainder(cell.position.x() - 0.1, 0.2), 0.0, 1e-9);
  }
}

TEST(MapWalls, ACellsPositionIsTheMeanOfItsColumnNotTheMiddle) {
  const auto walls = mapWalls(wall(4.0, 0.0, 2.0, 0.17), kVoxel);
  ASSERT_FALSE(walls.empty());
  EXPECT_NEAR(walls[3].position.y(), 0.17, 1e-12);
}

TEST(MapWalls, AWallIsAtLeastFourVoxelsHigh) {
  EXPECT_TRUE(mapWalls(wall(4.0, 0.0, 0.3), kVoxel).empty());
  EXPECT_FALSE(mapWalls(wall(4.0, 0.0, 0.41), kVoxel).empty());
}

TEST(MapWalls, GroundLevelOrSlopingIsNoWall) {
  EXPECT_TRUE(mapWalls(surface(5.0, [](double, double) { return 0.0; }), kVoxel).empty());
  EXPECT_TRUE(mapWalls(surface(5.0, [](double x, double) { return 0.05 * x; }), kVoxel).empty());
  EXPECT_TRUE(
      mapWalls(surface(5.0, [](double x, double y) { return 0.5 * x + 0.02 * std::sin(40 * y); }), kVoxel).empty());
}

TEST(MapWalls, AHoleEndsTheStretchAndTheLongestCounts) {
  Points points = wall(4.0, 0.0, 1.0);
  for (const auto& p : wall(4.0, 1.5, 3.5)) points.push_back(p);
  const auto walls = mapWalls(points, kVoxel);
  ASSERT_FALSE(walls.empty());
  EXPECT_NEAR(walls[0].bottom, 1.5, 1e-9);
  EXPECT_NEAR(walls[0].top, 3.5, 1e-9);
  Points close = wall(4.0, 0.0, 1.0);  // two empty voxels are still one wall
  for (const auto& p : wall(4.0, 1.29, 3.3)) close.push_back(p);
  EXPECT_NEAR(mapWalls(close, kVoxel)[0].bottom, 0.0, 1e-9);
}

TEST(MapWalls, PointsOfAnotherStretchDoNotMoveTheCell) {
  Points points = wall(4.0, 0.0, 2.0, 0.03);
  for (double x = 0.05; x < 4.0; x += kVoxel) points.emplace_back(x, 0.17, 5.0);  // a gutter above
  for (const WallCell& cell : mapWalls(points, kVoxel)) EXPECT_NEAR(cell.position.y(), 0.03, 1e-12);
}

TEST(MapWalls, ALonePostOrAScatterLinesUpWithNothing) {
  EXPECT_TRUE(mapWalls(wall(0.2, 0.0, 3.0), kVoxel).empty());
  std::mt19937_64 random(5);
  Points leaves;
  for (int i = 0; i < 20'000; ++i) {
    const double x = 2.0 * uniform(random), y = 2.0 * uniform(random);
    leaves.emplace_back(x, y, 2.0 * uniform(random));
  }
  EXPECT_LT(mapWalls(leaves, kVoxel).size(), 10U);  // of a hundred columns, a few at the rim
}

TEST(MapWalls, OfACylinderTheNormalsPointAtItsAxis) {
  Points points;
  for (double a = 0; a < kTurn; a += 0.02) {
    for (double z = 0; z < 2.0; z += kVoxel) points.emplace_back(7.0 + 5.0 * std::cos(a), 5.0 * std::sin(a), z);
  }
  const auto walls = mapWalls(points, kVoxel);
  ASSERT_GT(walls.size(), 120U);
  for (const WallCell& cell : walls) {
    const Eigen::Vector2d arm = cell.position - Eigen::Vector2d(7.0, 0.0);
    EXPECT_NEAR(arm.norm(), 5.0, 0.01);
    EXPECT_GT(std::abs(cell.normal.dot(arm.normalized())), 0.94);
    EXPECT_NEAR(cell.normal.norm(), 1.0, 1e-9);
  }
}

TEST(MapWalls, ScalesWithTheVoxel) {
  Points points = wall(4.0, 0.0, 2.0);
  EXPECT_FALSE(mapWalls(points, 0.4).empty());
  EXPECT_TRUE(mapWalls(points, 0.6).empty());   // two metres are not four voxels
  EXPECT_TRUE(mapWalls(points, 0.02).empty());  // five voxels between points
  for (auto& p : points) p *= 0.01;
  const auto small = mapWalls(points, 0.01 * kVoxel);
  ASSERT_EQ(small.size(), 20U);
  EXPECT_NEAR(small[0].top, 0.02, 1e-9);
}

TEST(MapWalls, DoNotDependOnTheOrderOfThePoints) {
  Points points = wall(4.0, 0.0, 2.0);
  const auto one = mapWalls(points, kVoxel);
  std::reverse(points.begin(), points.end());
  const auto other = mapWalls(points, kVoxel);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR((one[i].position - other[i].position).norm(), 0.0, 1e-12);
}

TEST(MapWalls, OfNothingAreNone) { EXPECT_TRUE(mapWalls({}, kVoxel).empty()); }

/// Upright posts, each of one column, at these places.
Points posts(const std::vector<Eigen::Vector2d>& places) {
  Points points;
  for (const auto& at : places) {
    for (double z = 0.0; z < 2.0; z += kVoxel) points.emplace_back(at.x(), at.y(), z);
  }
  return points;
}

TEST(MapWalls, ColumnsLineUpWithThoseUpToTwoCellsAway) {
  EXPECT_EQ(mapWalls(posts({{0.1, 0.1}, {0.5, 0.1}, {0.9, 0.1}}), kVoxel).size(), 1U);  // the one in the middle
  EXPECT_TRUE(mapWalls(posts({{0.1, 0.1}, {0.7, 0.1}, {1.3, 0.1}}), kVoxel).empty());
}

/// Whether a row of columns that stand this far from its line, on alternate sides, is a wall.
bool linesUp(double off) {
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 15; ++i) places.emplace_back(0.1 + 0.2 * i, 0.2 + (i % 2 == 0 ? off : -off));
  const auto walls = mapWalls(posts(places), kVoxel);
  return std::any_of(walls.begin(), walls.end(),
                     [](const WallCell& w) { return std::abs(w.position.x() - 1.5) < 0.01; });
}

/// Of five columns 0.2 m apart the variance along the row is 0.08 m2, across it 0.96 of the square.
TEST(MapWalls, ARowIsAWallUpToFifteenHundredthsOfItsVarianceAcrossIt) {
  EXPECT_TRUE(linesUp(std::sqrt(0.14 * 0.08 / 0.96)));
  EXPECT_FALSE(linesUp(std::sqrt(0.16 * 0.08 / 0.96)));
  EXPECT_TRUE(linesUp(std::sqrt(0.09 * 0.08 / 0.96)));
  EXPECT_FALSE(linesUp(std::sqrt(0.25 * 0.08 / 0.96)));
}

}  // namespace tank_datum::wall_map_test
