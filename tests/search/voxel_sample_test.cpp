#include "search/voxel_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace tank_datum::voxel_sample_test {

Points randomPoints(std::size_t count, double size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-size, size);
  Points points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(place(random), place(random), place(random));
  return points;
}

std::size_t voxelsOf(const Points& points, double voxel) {
  std::set<std::array<double, 3>> voxels;
  for (const auto& p : points) {
    voxels.insert({std::floor(p.x() / voxel), std::floor(p.y() / voxel), std::floor(p.z() / voxel)});
  }
  return voxels.size();
}

TEST(VoxelSample, OfNothingIsEmpty) {
  const VoxelSample sample({}, 100);
  EXPECT_TRUE(sample.points().empty());
  EXPECT_EQ(sample.shareHolding(1), 0.0);
}

TEST(VoxelSample, KeepsPointsOfDifferentVoxelsAndOneOfTwoInTheSame) {
  EXPECT_EQ(VoxelSample({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 100).points().size(), 4U);
  EXPECT_EQ(VoxelSample({{0.0002, 0, 0}, {0.0003, 0, 0}}, 100).points().size(), 1U);
  EXPECT_EQ(VoxelSample({{-0.0002, 0, 0}, {0.0002, 0, 0}}, 100).points().size(), 2U);
  EXPECT_EQ(VoxelSample(Points(50, {1, 2, 3}), 100).points(), (Points{{1, 2, 3}}));
}

TEST(VoxelSample, OfFarPointsHasTheSmallestVoxelsThatTwentyBitsNumberOnEachSide) {
  EXPECT_EQ(VoxelSample({{1048.5, 0, 0}, {0, -1048.5, 0}}, 100).voxel(), 0.001);
  EXPECT_EQ(VoxelSample({{1048.6, 0, 0}, {0, 1, 0}}, 100).voxel(), 0.002);
}

TEST(VoxelSample, HoldsOneScanPointForEachOccupiedVoxelAndNoMore) {
  const Points points = randomPoints(5000, 1.0);
  const VoxelSample sample(points, 1000);
  const Points kept = sample.points();
  EXPECT_GT(sample.voxel(), 0.01);
  EXPECT_EQ(voxelsOf(kept, sample.voxel()), kept.size());
  EXPECT_EQ(voxelsOf(points, sample.voxel()), kept.size());
  for (const auto& p : kept) EXPECT_EQ(std::count(points.begin(), points.end(), p), 1);
}

TEST(VoxelSample, NeverHoldsMoreThanItsBound) {
  for (const std::size_t bound : {10U, 100U, 101U, 1000U}) {
    for (const std::size_t count : {11U, 102U, 3000U}) {
      const VoxelSample sample(randomPoints(count, 50.0), bound);
      EXPECT_LE(sample.points().size(), bound) << count;
    }
  }
}

TEST(VoxelSample, TheBoundDecidesTheVoxel) {
  const Points points = randomPoints(20'000, 1.0);
  const VoxelSample small(points, 500), large(points, 15'000);
  EXPECT_GT(small.voxel(), large.voxel());
  EXPECT_LT(small.points().size(), large.points().size());
  EXPECT_GT(voxelsOf(points, 0.5 * small.voxel()), 500U);  // the smallest of the doubled voxels that fits
  EXPECT_GT(voxelsOf(points, 0.5 * large.voxel()), 15'000U);
}

TEST(VoxelSample, DoesNotDependOnTheOrderOfThePointsOrTheThreads) {
  for (const std::size_t count : {103U, 4000U}) {
    Points points = randomPoints(count, 3.0);
    const VoxelSample once(points, 100);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::shuffle(points.begin(), points.end(), std::mt19937(seed));
      const VoxelSample other(points, 100, 0.001, static_cast<int>(seed % 3));
      EXPECT_EQ(other.voxel(), once.voxel());
      EXPECT_EQ(other.points(), once.points());
      EXPECT_EQ(other.shareHolding(2), once.shareHolding(2));
    }
  }
}

TEST(VoxelSample, CoarsenDoublesTheVoxelAndKeepsOnePointInEach) {
  const Points points = randomPoints(2000, 0.02);
  VoxelSample sample(points, 10'000);
  for (int step = 0; step < 4; ++step) {
    const double voxel = sample.voxel();
    sample.coarsen();
    EXPECT_DOUBLE_EQ(sample.voxel(), 2 * voxel);
    EXPECT_EQ(sample.points().size(), voxelsOf(points, 2 * voxel));
  }
}

TEST(VoxelSample, CoarsenedIsTheSampleThatASmallerBoundGives) {
  const Points points = randomPoints(2000, 1.0);
  const VoxelSample bounded(points, 300);
  VoxelSample coarsened(points, 10'000);
  while (coarsened.voxel() < bounded.voxel()) coarsened.coarsen();
  EXPECT_EQ(coarsened.points(), bounded.points());
}

TEST(VoxelSample, CountsThePointsOfItsVoxels) {
  VoxelSample sample({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 100);
  EXPECT_DOUBLE_EQ(sample.shareHolding(1), 1.0);
  EXPECT_DOUBLE_EQ(sample.shareHolding(2), 0.5);
  EXPECT_DOUBLE_EQ(sample.shareHolding(3), 0.25);
  EXPECT_DOUBLE_EQ(sample.shareHolding(4), 0.0);
  while (sample.points().size() > 1) sample.coarsen();
  EXPECT_DOUBLE_EQ(sample.shareHolding(7), 1.0);
}

TEST(VoxelSample, GrowsItsVoxelsToReachFarPoints) {
  const VoxelSample sample({{0, 0, 0}, {5000, 0, 0}, {-5000, 9000, 1}}, 100);
  EXPECT_EQ(sample.points().size(), 3U);
  EXPECT_LT(sample.voxel(), 0.05);
}

TEST(VoxelSample, ItsSizeIsThatOfItsPoints) {
  VoxelSample sample(randomPoints(5000, 1.0), 1000);
  EXPECT_EQ(sample.size(), sample.points().size());
  sample.coarsen();
  EXPECT_EQ(sample.size(), sample.points().size());
  EXPECT_EQ(VoxelSample({}, 100).size(), 0U);
}

}  // namespace tank_datum::voxel_sample_test
