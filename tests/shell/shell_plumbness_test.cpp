#include "shell/shell_plumbness.h"

#include <gtest/gtest.h>

#include "shell/shell_lean.h"
#include "support/made_shells.h"

namespace tank_datum::shell_plumbness_test {

using namespace made_shells;

ShellGrid grid(const std::vector<double>& heights, const std::function<double(double, double)>& radius,
               double sigma = 1e-4) {
  ShellGrid made;
  made.heights = heights;
  made.step = kTurn * kRadius / 360;
  for (const double h : heights) {
    made.cells.emplace_back();
    for (const Station& s : stations()) made.cells.back().push_back({radius(s.direction, h), sigma, 1.0, 100});
  }
  return made;
}

const std::vector<double> kHeights = {0.3, 1.3, 2.3, 3.3, 4.3};

std::vector<Plumbness> all(const ShellGrid& made, const StationOptions& options = {}) {
  std::vector<Plumbness> result;
  const std::vector<Station> around = stations(options);
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Plumbness p = plumbnessAt(made, i, around[i]);
    if (std::isfinite(p.offset)) result.push_back(p);
  }
  return result;
}

TEST(PlumbnessAt, IsTheOffsetOfTheTopFromTheFoot) {
  const ShellGrid made = grid(kHeights, [](double, double h) { return kRadius + 0.004 * h; });
  const Plumbness p = plumbnessAt(made, 7, stations()[7]);
  EXPECT_NEAR(p.offset, 0.016, 1e-12);
  EXPECT_DOUBLE_EQ(p.height, 4.0);
  EXPECT_NEAR(p.slope, 0.004, 1e-12);
  EXPECT_NEAR(p.sigma, std::sqrt(2.0) * 1e-4, 1e-12);
  EXPECT_NEAR(p.sigma_slope, 1e-4 / std::sqrt(10.0), 1e-9);  // sum of squared heights about their mean
  EXPECT_NEAR(degrees(p.azimuth), 7.0, 1e-9);
}

TEST(PlumbnessAt, ABarrelIsStraightOnlyAsItsLineSays) {
  const ShellGrid made = grid(kHeights, [](double, double h) { return kRadius - 0.002 * (h - 2.3) * (h - 2.3); });
  const Plumbness p = plumbnessAt(made, 0, stations()[0]);
  EXPECT_NEAR(p.offset, 0.0, 1e-12);
  EXPECT_NEAR(p.slope, 0.0, 1e-12);
  EXPECT_GT(p.sigma_slope, 10 * 1e-4 / std::sqrt(10.0));
}

TEST(PlumbnessAt, CountsFromTheLowestHeightSeen) {
  ShellGrid made = grid(kHeights, [](double, double h) { return kRadius + 0.004 * h; });
  made.cells[0][5] = made.cells[1][5] = made.cells[4][5] = {};
  const Plumbness p = plumbnessAt(made, 5, stations()[5]);
  EXPECT_DOUBLE_EQ(p.height, 1.0);
  EXPECT_NEAR(p.offset, 0.004, 1e-12);
  EXPECT_TRUE(std::isnan(p.sigma_slope));  // two heights leave nothing over to judge a line by
  made.cells[3][5] = {};
  EXPECT_TRUE(std::isnan(plumbnessAt(made, 5, stations()[5]).offset));
}

TEST(PlumbnessOf, TheLargestOfManyNoisyOffsetsIsNotTakenForTheShells) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto noisy = [&](double a, double h) {
    return kRadius + h * 0.002 * std::cos(a - 1.0) + 0.0003 * normal(random);
  };
  const ShellGrid made = grid(kHeights, noisy, 0.0003);
  const auto larger = [](const Plumbness& a, const Plumbness& b) { return a.offset < b.offset; };
  const auto raw = all(made), smooth = plumbnessOf(made, stations());
  EXPECT_GT(std::max_element(raw.begin(), raw.end(), larger)->offset, 0.0086);
  const auto worst = std::max_element(smooth.begin(), smooth.end(), larger);
  EXPECT_NEAR(worst->offset, 0.008, 0.0004);
  EXPECT_LT(worst->sigma, raw[57].sigma / 2);
}

TEST(PlumbnessOf, OffsetsOverOtherHeightsAreNotMixedIn) {
  ShellGrid made = grid(
      kHeights, [](double, double h) { return kRadius + 0.004 * h; }, 0.01);
  for (std::size_t i = 0; i < 360; i += 2) made.cells[4][i] = {};
  made.cells[1][9] = made.cells[2][9] = made.cells[3][9] = made.cells[4][9] = {};
  const auto found = plumbnessOf(made, stations());
  ASSERT_EQ(found.size(), 359U);
  EXPECT_NEAR(found[8].offset, 0.012, 1e-9);
  EXPECT_NEAR(degrees(found[9].azimuth), 10.0, 1e-9);
  EXPECT_NEAR(found[10].offset, 0.016, 1e-9);
}

TEST(LeanOf, IsAmountAndDirection) {
  const auto leaning = [](double a, double h) { return kRadius + h * 0.005 * std::cos(a - 1.0); };
  const Lean lean = leanOf(all(grid(kHeights, leaning)), {});
  EXPECT_NEAR(lean.slope(), 0.005, 1e-9);
  EXPECT_NEAR(lean.direction, 1.0, 1e-9);
  EXPECT_NEAR(lean.offset(), 0.020, 1e-9);
  EXPECT_DOUBLE_EQ(lean.height, 4.0);
}

TEST(LeanOf, DirectionIsCountedAsTheUserCounts) {
  const auto leaning = [](double a, double h) { return kRadius + h * 0.005 * std::cos(a - 1.0); };
  StationOptions options;
  options.zero_azimuth = 0.4;
  ShellGrid made = grid(kHeights, leaning);
  for (std::size_t k = 0; k < kHeights.size(); ++k) {
    for (std::size_t i = 0; i < 360; ++i)
      made.cells[k][i].radius = leaning(stations(options)[i].direction, kHeights[k]);
  }
  EXPECT_NEAR(leanOf(all(made, options), options).direction, 0.6, 1e-9);
  options.clockwise = true;
  for (std::size_t k = 0; k < kHeights.size(); ++k) {
    for (std::size_t i = 0; i < 360; ++i)
      made.cells[k][i].radius = leaning(stations(options)[i].direction, kHeights[k]);
  }
  EXPECT_NEAR(leanOf(all(made, options), options).direction, kTurn - 0.6, 1e-9);
}

TEST(LeanOf, ShapesThatGrowAndCoursesThatStepAreNoLean) {
  const auto shape = [](double a, double h) { return kRadius + h * (0.004 * std::cos(2 * a) - 0.002); };
  const Lean lean = leanOf(all(grid(kHeights, shape)), {});
  EXPECT_LT(lean.slope(), 1e-6);
}

TEST(LeanOf, SigmaCoversTheErrorBehindAGap) {
  const auto shape = [](double a, double h) {
    return kRadius + h * (0.005 * std::cos(a - 1.0) + 0.0015 * std::cos(3 * a) + 0.001 * std::sin(8 * a));
  };
  ShellGrid made = grid(kHeights, shape);
  for (auto& row : made.cells) std::fill(row.begin() + 30, row.begin() + 120, ShellCell());
  const Lean lean = leanOf(all(made), {});
  const Eigen::Vector2d truth(0.005 * std::cos(1.0), 0.005 * std::sin(1.0));
  EXPECT_LT((lean.gradient - truth).norm(), 3.0 * lean.sigma);
  EXPECT_GT((lean.gradient - truth).norm(), 1e-6);
}

/// Standard error of a lean of which 90 degrees are hidden, beside so many lobes that grow with height.
double sigmaWithLobes(int lobes) {
  const auto shape = [lobes](double a, double h) { return kRadius + h * 0.001 * std::cos(lobes * a); };
  ShellGrid made = grid(kHeights, shape);
  for (auto& row : made.cells) std::fill(row.begin() + 30, row.begin() + 120, ShellCell());
  return leanOf(all(made), {}).sigma;
}

TEST(LeanOf, IsToldFromLobesUpToTheEighth) { EXPECT_LT(sigmaWithLobes(7), 0.5 * sigmaWithLobes(12)); }

TEST(LeanOf, OfAShortArcIsUnknownWhereAnyLeanWouldDo) {
  const auto sigma_of = [](double scatter) {  // of the slopes, by turns this way and that, over 40 degrees
    ShellGrid made = grid(kHeights, [&](double a, double h) {
      return kRadius + h * scatter * (std::lround(degrees(a)) % 2 == 0 ? 1.0 : -1.0);
    });
    for (auto& row : made.cells) std::fill(row.begin() + 40, row.end(), ShellCell());
    return leanOf(all(made), {}).sigma;
  };
  const double each = sigma_of(1e-5) / 1e-5;
  EXPECT_NEAR(sigma_of(0.004 / each), 0.004, 4e-4);
  EXPECT_TRUE(std::isnan(sigma_of(0.006 / each)));  // 95 % of it wider than the 0.01 by which shells lean
}

TEST(LeanOf, OfTooFewIsUnknown) {
  EXPECT_FALSE(leanOf({}, {}).valid());
  EXPECT_TRUE(std::isnan(Lean().offset()));
}

}  // namespace tank_datum::shell_plumbness_test
