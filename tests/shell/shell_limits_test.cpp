#include <gtest/gtest.h>

#include "shell/shell_lean.h"
#include "shell/shell_plumbness.h"
#include "shell/shell_roundness.h"
#include "support/made_shells.h"

namespace tank_datum::shell_limits_test {

using namespace made_shells;

Eigen::Vector3d pointAt(double azimuth, double outwards, double height) {
  const double r = kRadius + outwards;
  return {kCentre.x() + r * std::cos(azimuth), kCentre.y() + r * std::sin(azimuth), kFoot + height};
}

/// How many points the band at a height keeps of those given.
std::size_t keptOf(const Points& points, double height) {
  const ShellBands bands = bandsOf(points);
  const auto& heights = bands.heights();
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::abs(heights[k] - height) < 0.01) return bands.points(k).size();
  }
  return 0;
}

TEST(ShellBands, NoStorageTankIsHigherThanSixtyMetres) { EXPECT_NEAR(bandsOf({}).heights().back(), 60.0, 1.0); }

TEST(ShellBands, ABandIsTenCentimetresWiderThanAskedForOnEitherSideForTheDatumIsUneven) {
  EXPECT_EQ(keptOf({pointAt(1.0, 0.0, 0.3 + 0.19)}, 0.3), 1U);
  EXPECT_EQ(keptOf({pointAt(1.0, 0.0, 0.3 + 0.21)}, 0.3), 0U);
}

TEST(ShellBands, AShellMayLeanByOneInAHundred) {
  EXPECT_EQ(keptOf({pointAt(1.0, 0.3 + 0.0095 * 50.3, 50.3)}, 50.3), 1U);
  EXPECT_EQ(keptOf({pointAt(1.0, 0.3 + 0.0115 * 50.3, 50.3)}, 50.3), 0U);
}

TEST(ShellBands, HalfADegreeKeepsAHundredPointsAndAsManyForTheWiderBand) {
  Points points;
  for (int i = 0; i < 8000; ++i) points.push_back(pointAt(kTurn / 36.0 * (i + 0.5) / 8000.0, 0.0, 0.3));
  EXPECT_EQ(keptOf(points, 0.3), 20U * 200U);
}

/// The roundness of an exact shell seen at so many stations round it.
Roundness roundOf(int count, double sigma) {
  StationOptions options;
  options.count = count;
  std::vector<double> deviations;
  const std::vector<ShellCell> row(static_cast<std::size_t>(count), ShellCell{kRadius, sigma, 1.0, 100});
  return roundnessOf(row, 0.3, stations(options), {kCentre, kRadius}, deviations);
}

TEST(Roundness, IsToldByEightStations) {
  EXPECT_TRUE(roundOf(8, 1e-4).circle.valid());
  EXPECT_FALSE(roundOf(7, 1e-4).circle.valid());
}

// A parabola through n values is known in its middle to sqrt(9 / 4 n) of one; windows of up to 15 degrees on either
// side have n = 29.
const double kSmoothed = std::sqrt(9.0 / (4.0 * 29.0));

TEST(Roundness, ItsExtremesAreSmoothedOverFifteenDegreesOnEitherSide) {
  EXPECT_NEAR(roundOf(360, 0.001).sigma, 0.001 * kSmoothed, 1e-5);
}

/// Plumbness of a shell that leans by 0.002, with a wave, at so many stations.
std::vector<Plumbness> leaning(int count) {
  std::vector<Plumbness> all;
  for (int i = 0; i < count; ++i) {
    Plumbness p;
    p.direction = p.azimuth = kTurn * i / count;
    p.height = 4.0, p.slope = 0.002 * std::cos(p.direction) + 0.0005 * std::cos(9.0 * p.direction);
    all.push_back(p);
  }
  return all;
}

TEST(LeanOf, IsToldByEightStations) {
  EXPECT_TRUE(leanOf(leaning(9), {}).valid());
  EXPECT_FALSE(leanOf(leaning(7), {}).valid());
}

TEST(LeanOf, StationsOfTenDegreesSayTheSame) {
  EXPECT_NEAR(leanOf(leaning(360), {}).sigma / leanOf(leaning(36), {}).sigma, 1.0, 0.1);
  EXPECT_NEAR(leanOf(leaning(36), {}).sigma / leanOf(leaning(24), {}).sigma, std::sqrt(24.0 / 36.0), 0.1);
}

TEST(PlumbnessOf, OffsetsAreSmoothedOverFifteenDegreesOnEitherSide) {
  ShellGrid grid;
  grid.step = kTurn * kRadius / 360.0;
  grid.heights = {0.3, 4.3};
  grid.cells.assign(2, std::vector<ShellCell>(360, ShellCell{kRadius, 0.001, 1.0, 100}));
  const double alone = std::sqrt(2.0) * 0.001;
  EXPECT_NEAR(plumbnessOf(grid, stations()).front().sigma, alone * kSmoothed, 1e-5);
}

}  // namespace tank_datum::shell_limits_test
