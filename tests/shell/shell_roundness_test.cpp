#include "shell/shell_roundness.h"

#include <gtest/gtest.h>

#include "shell/shell_measures.h"
#include "support/made_shells.h"

namespace tank_datum::shell_roundness_test {

using namespace made_shells;

/// Cells all round by a formula of the azimuth, no noise in them.
std::vector<ShellCell> cells(const std::function<double(double)>& radius, double sigma = 1e-4) {
  std::vector<ShellCell> row;
  for (const Station& s : stations()) row.push_back({radius(s.direction), sigma, 1.0, 100});
  return row;
}

Roundness roundOf(const std::vector<ShellCell>& row, double height = 0.3, double radius = kRadius) {
  std::vector<double> deviations;
  return roundnessOf(row, height, stations(), {kCentre, radius}, deviations);
}

LimitComparison besideLimits(const Roundness& r, const std::vector<Limit>& limits = standardLimits(),
                             double diameter = 2.0 * kRadius) {
  ShellSurvey survey;
  survey.roundness = {r};
  TankFacts facts;
  facts.service = Service::Rebuilt;
  return compareRoundness(survey, limits, facts, {diameter}).at(0);
}

Verdict verdictOf(const Roundness& r) { return besideLimits(r).verdict; }

TEST(Roundness, OfACircleIsNothing) {
  const Roundness r = roundOf(cells([](double) { return kRadius + 0.004; }));
  EXPECT_NEAR(r.circle.radius, kRadius + 0.004, 1e-9);
  EXPECT_NEAR(r.largest(), 0.0, 1e-9);
  EXPECT_EQ(r.stations, 360U);
  EXPECT_EQ(verdictOf(r), Verdict::Pass);
}

TEST(Roundness, WhatMayBeADentIsUndecidedWhatIsFartherOffStandsBeforeIt) {
  const auto with = [](double off) {
    std::vector<ShellCell> row = cells([](double) { return kRadius; });
    row[40] = {};
    row[40].doubted = kRadius + off;
    return roundOf(row);
  };
  EXPECT_NEAR(with(-0.080).doubted, 0.080, 1e-9);
  EXPECT_NEAR(with(-0.080).largest(), 0.0, 1e-9);
  EXPECT_EQ(verdictOf(with(-0.080)), Verdict::Undecided);
  EXPECT_EQ(verdictOf(with(0.090)), Verdict::Undecided);
  EXPECT_EQ(verdictOf(with(0.110)), Verdict::Pass);
  EXPECT_EQ(verdictOf(with(0.010)), Verdict::Pass);
}

TEST(Roundness, AShiftedCircleIsRound) {
  const Eigen::Vector2d shift(0.06, -0.03);
  const auto radius = [&](double a) {
    const Eigen::Vector2d out(std::cos(a), std::sin(a));
    const double along = shift.dot(out), across = shift.squaredNorm() - along * along;
    return along + std::sqrt(kRadius * kRadius - across);
  };
  const Roundness r = roundOf(cells(radius), 6.3);
  EXPECT_LT(r.largest(), 1e-9);
  EXPECT_NEAR((r.circle.center - kCentre - shift).norm(), 0.0, 1e-9);
}

TEST(Roundness, OfAnOvalIsItsAmplitudeAtItsAxes) {
  const Roundness r = roundOf(cells([](double a) { return kRadius + 0.012 * std::cos(2 * (a - 0.5)); }));
  EXPECT_NEAR(r.max_deviation, 0.012, 2e-5);
  EXPECT_NEAR(r.min_deviation, -0.012, 2e-5);
  EXPECT_NEAR(std::remainder(r.azimuth - 0.5, kTurn / 4), 0.0, kTurn / 360);
  EXPECT_EQ(verdictOf(r), Verdict::Pass);
}

TEST(Roundness, TheWorstPlaceIsTheLargerOfInAndOut) {
  const auto dented = [](double a) { return kRadius - 0.05 * std::exp(-0.5 * std::pow((a - 4.0) / 0.1, 2)); };
  const Roundness r = roundOf(cells(dented));
  const double mean = 0.05 * 0.1 / std::sqrt(kTurn);  // the circle is smaller by that, and gives way by twice as much
  EXPECT_NEAR(r.min_deviation, -0.05 + 3.0 * mean, 4e-4);  // smoothing may take three of a cell's sigmas
  EXPECT_NEAR(r.azimuth, 4.0, kTurn / 360);
  EXPECT_LT(r.max_deviation, 0.01);
  EXPECT_EQ(r.largest(), -r.min_deviation);
  EXPECT_EQ(verdictOf(r), Verdict::Fail);
}

TEST(Roundness, AGapTakesNothingOfAnOvalAway) {
  auto row = cells([](double a) { return kRadius + 0.015 * std::cos(2 * a) + 0.004 * std::cos(5 * a); });
  const Roundness whole = roundOf(row);
  for (std::size_t i = 340; i < 380; ++i) row[i % 360] = {};
  const Roundness part = roundOf(row);
  EXPECT_EQ(part.stations, 320U);
  EXPECT_NEAR(part.widest_gap, 41 * kTurn / 360 * kRadius, 1e-9);
  EXPECT_NEAR(part.circle.radius, whole.circle.radius, 2e-4);  // 1.1 mm without looking at the shape
  EXPECT_NEAR(part.min_deviation, whole.min_deviation, 3e-4);
}

TEST(Roundness, SigmaGrowsByWhatAGapMayHide) {
  auto row = cells([](double a) { return kRadius + 0.015 * std::cos(2 * a) + 0.004 * std::cos(6 * a + 1.0); });
  const Roundness whole = roundOf(row);
  for (std::size_t i = 60; i < 130; ++i) row[i] = {};
  const Roundness part = roundOf(row);
  EXPECT_GT(part.sigma, 3.0 * whole.sigma);
  EXPECT_LT(std::abs(part.max_deviation - whole.max_deviation), 2.0 * part.sigma);
}

TEST(Roundness, LessThanHalfOfTheShellGivesNoCircle) {
  auto row = cells([](double) { return kRadius; });
  for (std::size_t i = 0; i < 360; i += 2) row[i] = {};
  EXPECT_TRUE(roundOf(row).circle.valid());
  row[1] = {};
  EXPECT_FALSE(roundOf(row).circle.valid());
}

TEST(Roundness, WhatPassesButWasNotAllSeenIsUndecided) {
  auto row = cells([](double) { return kRadius; });
  for (std::size_t i = 0; i < 40; ++i) row[i] = {};  // 7 m
  EXPECT_EQ(verdictOf(roundOf(row)), Verdict::Undecided);
  for (std::size_t i = 0; i < 40; i += 20) row[i] = {kRadius, 1e-4, 1.0, 100};
  EXPECT_EQ(verdictOf(roundOf(row)), Verdict::Pass);
}

TEST(Roundness, ATooWideGapGivesNoCircle) {
  auto row = cells([](double) { return kRadius; });
  for (std::size_t i = 0; i < 125; ++i) row[i] = {};
  EXPECT_FALSE(roundOf(row).circle.valid());
  EXPECT_FALSE(roundOf(std::vector<ShellCell>(360)).circle.valid());
}

TEST(Roundness, TheToleranceWithinTheIntervalIsUndecided) {
  const auto oval = [](double amplitude, double sigma) {
    return cells([=](double a) { return kRadius + amplitude * std::cos(2 * a); }, sigma);
  };
  EXPECT_EQ(verdictOf(roundOf(oval(0.0187, 1e-4))), Verdict::Pass);
  EXPECT_EQ(verdictOf(roundOf(oval(0.0193, 1e-4))), Verdict::Fail);
  EXPECT_EQ(verdictOf(roundOf(oval(0.0187, 2e-3))), Verdict::Undecided);
  EXPECT_EQ(verdictOf(roundOf(oval(0.0193, 2e-3))), Verdict::Undecided);
  EXPECT_EQ(verdictOf(roundOf(oval(0.0193, 1e-4), 1.3)), Verdict::Pass);  // three times as much higher up
}

TEST(Roundness, ToleranceIsThatOfTheDiametersClass) {
  const auto tolerance = [](double diameter, double height) {
    Roundness r = roundOf(cells([](double) { return kRadius; }), height);
    return besideLimits(r, standardLimits(), diameter).limit;
  };
  EXPECT_EQ(tolerance(11.99, 0.3), 0.013);
  EXPECT_EQ(tolerance(12.0, 0.3), 0.019);
  EXPECT_EQ(tolerance(44.99, 0.3), 0.019);
  EXPECT_EQ(tolerance(45.0, 0.3), 0.025);
  EXPECT_EQ(tolerance(74.99, 0.3), 0.025);
  EXPECT_EQ(tolerance(75.0, 0.3), 0.032);
  EXPECT_DOUBLE_EQ(tolerance(60.0, 1.3), 0.075);
  EXPECT_TRUE(isAtFoot(0.3));
  EXPECT_FALSE(isAtFoot(0.5));
}

TEST(Roundness, IsJudgedByTheLimitsGiven) {
  std::vector<Limit> strict = standardLimits();
  for (Limit& limit : strict) limit.at_most = 0.0001;
  const Roundness r = roundOf(cells([](double a) { return kRadius + 0.0001 * std::cos(2 * a); }));
  EXPECT_EQ(verdictOf(r), Verdict::Pass);
  EXPECT_EQ(besideLimits(r, strict).limit, 0.0001);
  EXPECT_EQ(besideLimits(r, strict).verdict, Verdict::Undecided);
  EXPECT_EQ(besideLimits(r, {}).verdict, Verdict::NotEvaluated);
  EXPECT_TRUE(std::isnan(besideLimits(r, {}).limit));
}

TEST(Roundness, DeviationsAreEachStationsOwn) {
  auto row = cells([](double a) { return kRadius + 0.01 * std::cos(3 * a); });
  row[17] = {};
  std::vector<double> deviations;
  roundnessOf(row, 0.3, stations(), {kCentre, kRadius}, deviations);
  ASSERT_EQ(deviations.size(), 360U);
  EXPECT_TRUE(std::isnan(deviations[17]));
  for (const std::size_t i : {0U, 60U, 90U, 200U}) {
    EXPECT_NEAR(deviations[i], 0.01 * std::cos(3 * kTurn * static_cast<double>(i) / 360), 2e-5) << i;
  }
}

/// The highest of the eight waves is drawn to nought by a thousandth of the stations' weight, of which it has half.
TEST(Roundness, WhatIsNotSeenIsTakenFromWavesThatAreKeptQuiet) {
  constexpr double kAmplitude = 0.1;
  const auto whole = cells([](double a) { return kRadius + kAmplitude * std::cos(8 * a); });
  auto part = whole;
  part[0] = {};  // on a crest; of the circle it is one of 360
  const double lost = 360.0 * (roundOf(whole).circle.radius - roundOf(part).circle.radius);
  EXPECT_NEAR(lost / kAmplitude, 2e-3, 3e-4);
}

}  // namespace tank_datum::shell_roundness_test
