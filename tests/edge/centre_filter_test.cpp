#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "support/refused.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum::centre_filter_test {

using Indices = std::vector<std::int32_t>;
constexpr double kTurn = 6.283185307179586;
const Circle kTank{{12.0, -7.0}, 20.0};

CentreFilterOptions within(double tolerance) {
  CentreFilterOptions options;
  options.tolerance = tolerance;
  return options;
}

Eigen::Vector3d placeAt(const Circle& circle, double azimuth, double off = 0.0) {
  const double r = circle.radius + off;
  return {circle.center.x() + r * std::cos(azimuth), circle.center.y() + r * std::sin(azimuth), 0.1};
}

/// Points of a circle in order round it, with normal errors along the radius.
Points circleOf(const Circle& circle, std::size_t count, double noise = 0.0) {
  std::mt19937 random(1);
  std::normal_distribution<double> error(0.0, 1.0);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(
        placeAt(circle, kTurn * static_cast<double>(i) / static_cast<double>(count), noise * error(random)));
  }
  return points;
}

Indices allOf(const Points& points) {
  Indices all(points.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void expectCircle(const Circle& circle, const Circle& expected, double tolerance) {
  ASSERT_TRUE(circle.valid());
  EXPECT_NEAR(circle.center.x(), expected.center.x(), tolerance);
  EXPECT_NEAR(circle.center.y(), expected.center.y(), tolerance);
  EXPECT_NEAR(circle.radius, expected.radius, tolerance);
}

TEST(CentreFilter, KeepsAllOfACircleAndDropsItsCentre) {
  Points points = circleOf(kTank, 12);
  points.emplace_back(12.0, -7.0, 0.1);
  const EdgePoints edge = filterByCentre(points, allOf(points), kTank, {});
  expectCircle(edge.circle, kTank, 1e-9);
  EXPECT_EQ(edge.indices.size(), 12U);
  EXPECT_EQ(std::count(edge.indices.begin(), edge.indices.end(), 12), 0);
}

TEST(CentreFilter, OrdersByAzimuthFromZeroToATurn) {
  Points points = circleOf(kTank, 50);
  Indices candidates = allOf(points);
  std::shuffle(candidates.begin(), candidates.end(), std::mt19937(3));
  const EdgePoints edge = filterByCentre(points, candidates, kTank, {});
  ASSERT_EQ(edge.azimuths.size(), 50U);
  EXPECT_TRUE(std::is_sorted(edge.azimuths.begin(), edge.azimuths.end()));
  for (std::size_t i = 0; i < 50; ++i) {
    const auto own = static_cast<std::size_t>(edge.indices[i]);
    const double expected = kTurn * static_cast<double>(own) / 50;
    EXPECT_NEAR(std::remainder(edge.azimuths[i] - expected, kTurn), 0.0, 1e-9) << i;
    EXPECT_GE(edge.azimuths[i], 0.0);
    EXPECT_LT(edge.azimuths[i], kTurn);
  }
}

TEST(CentreFilter, LooksAtCandidatesOnly) {
  const Points points = circleOf(kTank, 40);
  const Indices candidates = {1, 5, 9, 13, 17, 21, 25, 29, 33, 37};
  EXPECT_EQ(filterByCentre(points, candidates, kTank, {}).indices, candidates);
}

TEST(CentreFilter, DistanceIsInPlan) {
  Points points = circleOf(kTank, 40);
  points[7].z() = 5.0;
  EXPECT_EQ(filterByCentre(points, allOf(points), kTank, {}).indices.size(), 40U);
}

TEST(CentreFilter, ToleranceDecidesWhatIsNoise) {
  Points points = circleOf(kTank, 100);
  const std::size_t on_circle = points.size();
  for (const double off : {0.02, -0.02, 0.07, -0.07, 0.3, -0.3}) points.push_back(placeAt(kTank, 1.0, off));
  const auto kept = [&](double tolerance) {
    return filterByCentre(points, allOf(points), kTank, within(tolerance)).indices.size() - on_circle;
  };
  EXPECT_EQ(kept(0.01), 0U);
  EXPECT_EQ(kept(0.05), 2U);
  EXPECT_EQ(kept(0.1), 4U);
  EXPECT_EQ(kept(0.5), 6U);
  EXPECT_EQ(kept(0.0), 4U);  // chosen: 0.1 m
  EXPECT_DOUBLE_EQ(filterByCentre(points, allOf(points), kTank, within(0.05)).tolerance, 0.05);
}

TEST(CentreFilter, ChosenToleranceIsATenthOfASmallRadius) {
  const Circle pipe{{1, 1}, 0.4};
  const Points points = circleOf(pipe, 40);
  EXPECT_NEAR(filterByCentre(points, allOf(points), pipe, {}).tolerance, 0.04, 1e-9);
  const Points big = circleOf(kTank, 40);
  EXPECT_DOUBLE_EQ(filterByCentre(big, allOf(big), kTank, {}).tolerance, 0.1);
}

TEST(CentreFilter, FindsTheCircleAmongFortyPercentClutterWithoutAStart) {
  Points points = circleOf(kTank, 600, 0.005);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-25, 25);
  for (int i = 0; i < 400; ++i) points.emplace_back(12 + place(random), -7 + place(random), 0.1);
  const EdgePoints edge = filterByCentre(points, allOf(points), std::nullopt, {});
  expectCircle(edge.circle, kTank, 0.005);
  const auto kept = [&](std::int32_t from, std::int32_t to) {
    return std::count_if(edge.indices.begin(), edge.indices.end(), [&](auto i) { return i >= from && i < to; });
  };
  EXPECT_EQ(kept(0, 600), 600);
  EXPECT_LT(kept(600, 1000), 12);  // 0.2 m of width x a 125.7 m turn of 50 x 50 m: 4 of 400
}

TEST(CentreFilter, RefinesAStartThatIsOffByLessThanTheTolerance) {
  const Points points = circleOf(kTank, 500, 0.003);
  const EdgePoints edge = filterByCentre(points, allOf(points), Circle{{12.06, -7.05}, 20.05}, {});
  expectCircle(edge.circle, kTank, 0.001);
  EXPECT_EQ(edge.indices.size(), 500U);
}

TEST(CentreFilter, TheStartDecidesBetweenTwoTanks) {
  const Circle other{{70, 0}, 15};
  Points points = circleOf(kTank, 500);
  for (const auto& p : circleOf(other, 300)) points.push_back(p);
  expectCircle(filterByCentre(points, allOf(points), other, {}).circle, other, 1e-6);
  expectCircle(filterByCentre(points, allOf(points), kTank, {}).circle, kTank, 1e-6);
  expectCircle(filterByCentre(points, allOf(points), std::nullopt, {}).circle, kTank, 1e-6);
}

TEST(CentreFilter, PullsNothingTowardsAPipeBesideTheShell) {
  Points points = circleOf(kTank, 1000, 0.002);
  for (int i = 0; i < 100; ++i) points.push_back(placeAt(kTank, 2.0 + 0.001 * i, 0.15));
  const EdgePoints edge = filterByCentre(points, allOf(points), kTank, {});
  expectCircle(edge.circle, kTank, 0.001);
  EXPECT_EQ(edge.indices.size(), 1000U);
}

TEST(CentreFilter, HasNoCircleForCollinearOrTooFewCandidates) {
  Points line;
  for (int i = 0; i < 60; ++i) line.emplace_back(0.5 * i, 2.0, 0.0);
  for (const Points& points : {line, Points{{1, 2, 3}, {4, 5, 6}}, Points()}) {
    for (const std::optional<Circle>& start : {std::optional<Circle>(), std::optional<Circle>(kTank)}) {
      const EdgePoints edge = filterByCentre(points, allOf(points), start, {});
      EXPECT_FALSE(edge.circle.valid()) << points.size();
      EXPECT_TRUE(edge.indices.empty());
      EXPECT_TRUE(edge.azimuths.empty());
    }
  }
}

TEST(CentreFilterOptions, RefuseAToleranceBelowZeroByName) {
  EXPECT_EQ(said(firstError(CentreFilterOptions())), "");
  EXPECT_EQ(said(firstError(within(0.2))), "");
  EXPECT_EQ(said(firstError(within(-0.1))), "centre_tolerance, -0.1, expected >= 0 m");
  EXPECT_NE(said(firstError(within(NAN))), "");
  EXPECT_NE(said(firstError(within(INFINITY))), "");
}

}  // namespace tank_datum::centre_filter_test
