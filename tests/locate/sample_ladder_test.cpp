#include "locate/sample_ladder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_clouds.h"

namespace tank_datum::sample_ladder_test {

TEST(StrideOf, AboutTwoMillionPointsAreLookedAtEveryOddNth) {
  EXPECT_EQ(strideOf(0), 1U);
  EXPECT_EQ(strideOf(3'900'000), 1U);
  EXPECT_EQ(strideOf(5'000'000), 3U);
  EXPECT_EQ(strideOf(20'000'000), 11U);
}

TEST(FinestVoxel, NumbersTheFarthestPointWithNineteenBits) {
  for (const double reach : {0.05, 1.0, 30.0, 500.0, 4000.0}) {
    const double farthest = reach / finestVoxel(Points(1, {0.0, -reach, 0.0}), 1);  // in voxels
    EXPECT_LE(farthest, 524'288.0) << reach;
    EXPECT_GT(farthest, 262'144.0) << reach;
  }
}

TEST(FinestVoxel, OfEveryScanIsOnOneLadder) {
  for (const double reach : {0.05, 1.0, 30.0, 500.0, 4000.0}) {
    const double rung = std::log2(finestVoxel(Points(1, {reach, 0.0, 0.0}), 1) / 0.008);
    EXPECT_EQ(rung, std::round(rung)) << reach;
  }
}

/// Edge of the coarsest sample of a floor of 8 m x 8 m on which every point was seen twice.
double coarsestOf(double min_radius) {
  LocateOptions options;
  options.min_radius = min_radius;
  Points floor = made_clouds::floorPoints(20'000, 8.0);
  const Points again = floor;
  floor.insert(floor.end(), again.begin(), again.end());
  return samplesOf(floor, options, 1).back().voxel;
}

TEST(SamplesOf, EndBeyondAnEighthOfTheSmallestTankOrASixtiethOfTheScan) {
  EXPECT_EQ(coarsestOf(1.5), 0.512);  // the rung after 0.375 m
  EXPECT_EQ(coarsestOf(0.1), 0.064);  // after 1/60 of the 2.5 m within which two in five points lie
}

}  // namespace tank_datum::sample_ladder_test
