#include "locate/stray_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "io/point_extent.h"
#include "locate/foot_unit.h"

namespace tank_datum::stray_points_test {

Points uniformPoints(std::size_t count, const Eigen::Vector3d& size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.emplace_back(size.x() * uniform(random), size.y() * uniform(random), size.z() * uniform(random));
  }
  return points;
}

Points floorPoints() { return uniformPoints(40'000, {20.0, 20.0, 0.002}, 1); }

Points with(Points points, const Points& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

TEST(Extent, TwoInFivePointsMayBeAnywhere) {
  const Extent clean = extentOf(floorPoints());
  EXPECT_NEAR(clean.reach, 6.3, 0.2);  // the square that holds two in five of 20 m x 20 m
  const Extent dirty = extentOf(with(floorPoints(), Points(20'000, {1e6, -1e7, 3e5})));
  EXPECT_LT(dirty.reach, 12.0);
  EXPECT_TRUE(dirty.holds({900.0, 0.0, 0.0}));
  EXPECT_FALSE(dirty.holds({10'000.0, 0.0, 0.0}));
}

TEST(DropNoReturns, RowsAtZeroAndFarOnes) {
  const Eigen::Vector3d zero(-400'000.0, -5'000'000.0, -30.0);
  Points points = with(floorPoints(), {zero, zero, {1e6, 0.0, 0.0}, {400.0, 0.0, 0.0}});
  dropNoReturns(points, zero);
  EXPECT_EQ(points.size(), 40'001U);
  dropNoReturns(points, zero);
  EXPECT_EQ(points.size(), 40'001U);
  Points none(5, zero);
  dropNoReturns(none, zero);
  EXPECT_TRUE(none.empty());
}

TEST(Strays, ACleanSurfaceHoldsNone) {
  const VoxelSample sample(floorPoints(), 1'000'000);
  EXPECT_FALSE(holdsStrays(sample));
  EXPECT_FALSE(holdsStrays(VoxelSample(with(floorPoints(), uniformPoints(600, {20.0, 20.0, 8.0}, 2)), 1'000'000)));
}

TEST(Strays, AreFoundAndTakenOut) {
  for (const std::size_t count : {8'000U, 20'000U}) {
    const Points points = with(floorPoints(), uniformPoints(count, {20.0, 20.0, 60.0}, 3));
    const VoxelSample sample(points, 1'000'000);
    EXPECT_TRUE(holdsStrays(sample)) << count;
    const Points kept = withoutStrays(points, closingEdge(sample));
    const auto on_floor = static_cast<std::size_t>(
        std::count_if(kept.begin(), kept.end(), [](const auto& p) { return std::abs(p.z()) <= 0.001; }));
    EXPECT_GT(on_floor, 38'000U) << count;
    EXPECT_LT(kept.size() - on_floor, count / 10) << count;
  }
}

TEST(ShareAlone, OfAGrid) {
  Points grid;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) grid.emplace_back(0.5 + i, 0.5 + j, 0.5);
  }
  const VoxelSample sample(grid, 100'000, 0.125);
  EXPECT_EQ(sample.shareAlone(0.125), 1.0);
  EXPECT_EQ(sample.shareAlone(1.0), 1.0);
  EXPECT_EQ(sample.shareAlone(2.0), 0.0);
  EXPECT_EQ(sample.edgeWithAlone(0.6), 2.0);
  grid.emplace_back(200.5, 200.5, 0.5);
  EXPECT_NEAR(VoxelSample(grid, 100'000, 0.125).shareAlone(2.0), 1.0 / 4097.0, 1e-12);
}

TEST(FootUnit, MetresBetweenADrumAndTheLargestTank) {
  EXPECT_EQ(footUnit(1.0, 0.001), 1.0);
  EXPECT_EQ(footUnit(100.0, 0.001), 1.0);
  EXPECT_DOUBLE_EQ(footUnit(0.99, 0.001), 0.099);
  EXPECT_DOUBLE_EQ(footUnit(101.0, 0.001), 10.1);
  EXPECT_DOUBLE_EQ(footUnit(10'670.0, 10.0), 1067.0);
  EXPECT_DOUBLE_EQ(footUnit(0.1067, 0.0001), 0.01067);
  EXPECT_EQ(footUnit(0.0387, 0.001), 1.0);  // a mug of 39 points to its radius
  EXPECT_EQ(footUnit(0.1, 0.1 / 59.0), 1.0);
  EXPECT_LT(footUnit(0.1, 0.1 / 61.0), 1.0);
}

/// The company of a point as its definition says it: points in the cell of its own and the 26 about it.
std::size_t companyOf(const Points& points, const Eigen::Vector3d& point, double edge) {
  const auto cell = [edge](const Eigen::Vector3d& p) -> Eigen::Array3d { return (p.array() / (2.0 * edge)).floor(); };
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return ((cell(p) - cell(point)).abs() <= 1.0).all();
  }));
}

TEST(FindStrays, OfAnyPointsThoseWithLessCompanyThanFive) {
  Points points = with(uniformPoints(1'500, {3.0, 2.0, 0.01}, 7), uniformPoints(900, {5.0, 4.0, 3.0}, 8));
  for (const double far : {1e3, 1e15, 1e300}) {
    points.emplace_back(far, -far, far);
    points.emplace_back(-far, far, -far);
  }
  for (const double edge : {0.03, 0.06, 0.12}) {
    const std::vector<char> is_stray = findStrays(points, edge);
    std::size_t strays = 0;
    for (std::size_t i = 0; i < points.size() - 6; ++i) {
      ASSERT_EQ(is_stray[i] == 1, companyOf(points, points[i], edge) < 5) << i << " at " << edge;
      strays += static_cast<std::size_t>(is_stray[i]);
    }
    EXPECT_GT(strays, 100U) << edge;
    EXPECT_EQ(std::count(is_stray.end() - 6, is_stray.end(), 1), 6) << edge;
  }
}

TEST(FindStrays, OfNoPoints) { EXPECT_TRUE(findStrays({}, 0.01).empty()); }

TEST(FindStrays, OfAFloorSeenFourTimesInClustersNoneIs) {
  Points points;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      for (int k = 0; k < 4; ++k) points.emplace_back(0.1 * i + 1e-4 * k, 0.1 * j + 5e-5 * k, 1e-5 * k);
    }
  }
  const std::vector<char> is_stray = findStrays(points, 0.001);  // an edge at which the clusters close
  EXPECT_EQ(std::count(is_stray.begin(), is_stray.end(), 1), 0);
}

/// A floor of points 1 m apart and beside it, far from each other, groups of points 1 mm apart: `strays` of all points.
/// Strays of one pair are `apart` from each other.
Points floorAndStrays(double strays, double apart) {
  Points points;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) points.emplace_back(0.5 + i, 0.5 + j, 0.5);
  }
  const int pairs = static_cast<int>(std::lround(0.5 * 4096.0 * strays / (1.0 - strays)));
  for (int k = 0; k < pairs; ++k) {
    const Eigen::Vector3d at(256.5 + 256.0 * (k % 64), 256.5 + 256.0 * (k / 64), 0.5);
    points.push_back(at);
    points.emplace_back(at.x() + apart, at.y(), at.z());
  }
  return points;
}

/// The floor closes at voxels of 2 m; pairs 4 m apart are alone in voxels of 4 m, not of 8 m.
TEST(HoldsStrays, AreMoreThanASixthAtTwiceTheClosingEdgeOrATwentiethAtFourTimes) {
  const auto holds = [](double strays, double apart) {
    return holdsStrays(VoxelSample(floorAndStrays(strays, apart), 1'000'000, 0.125));
  };
  EXPECT_FALSE(holds(0.14, 4.0));
  EXPECT_TRUE(holds(0.16, 4.0));
  EXPECT_FALSE(holds(0.045, 64.0));
  EXPECT_TRUE(holds(0.055, 64.0));
}

/// With 0.4 of the points strays that share voxels of 16 m, surfaces close at 2 m all the same.
TEST(HoldsStrays, SurfacesCloseWhereSixInTenPointsMayBeAlone) {
  EXPECT_TRUE(holdsStrays(VoxelSample(floorAndStrays(0.4, 8.0), 1'000'000, 0.125)));
}

TEST(ClosingEdge, IsWhereThreeInTenPointsShareTheirVoxels) {
  EXPECT_EQ(closingEdge(VoxelSample(floorAndStrays(0.68, 16.0), 1'000'000, 0.125)), 2.0);
  EXPECT_EQ(closingEdge(VoxelSample(floorAndStrays(0.72, 16.0), 1'000'000, 0.125)), 32.0);
}

/// How many points are found to be strays beside a floor of 1000 points within a millimetre.
std::ptrdiff_t straysOf(std::size_t groups, std::size_t of_each) {
  Points points(1000, {0.5, 0.5, 0.5});
  for (std::size_t k = 0; k < groups; ++k) {
    for (std::size_t i = 0; i < of_each; ++i) points.emplace_back(100.0 + 10.0 * static_cast<double>(k), 0.0, 0.001);
  }
  const std::vector<char> is_stray = findStrays(points, 0.1);
  return std::count(is_stray.begin(), is_stray.end(), 1);
}

TEST(FindStrays, FivePointsTogetherAreASurfaceFourAreNot) {
  EXPECT_EQ(straysOf(10, 4), 40);
  EXPECT_EQ(straysOf(10, 5), 0);
}

TEST(FindStrays, SixInTenPointsAreStraysAtMost) {
  EXPECT_EQ(straysOf(1400, 1), 1400);  // 0.58
  EXPECT_EQ(straysOf(1600, 1), 0);     // 0.62
}

}  // namespace tank_datum::stray_points_test
