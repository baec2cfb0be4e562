#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_overlaps.h"

namespace tank_datum::bad_setups_test {

using namespace made_overlaps;

/// A survey without errors of its setups.
Recipe withoutErrors() {
  Recipe recipe;
  recipe.sigma_error = recipe.sigma_plan = 1e-9, recipe.sigma_tilt = 1e-12, recipe.sigma_arc = 2e-5;
  return recipe;
}

/// What becomes of so many setups without errors but those put on: parameter (5 times the setup, and dz, tilt_x,
/// tilt_y, dx, dy) and size.
SetupAdjustment adjusted(std::size_t setups, const std::vector<std::pair<int, double>>& errors) {
  Recipe recipe = withoutErrors();
  recipe.setups = setups;
  recipe.half_view = std::max(44.0, 280.0 / static_cast<double>(setups)) * kPi / 180.0;
  std::mt19937_64 random(4);
  Survey survey = made(recipe, random);
  for (const auto& [parameter, error] : errors) survey.errors[parameter] += error;
  look(recipe, survey, random);
  return adjustSetups(survey.arcs, setups, {});
}

std::vector<bool> badOf(std::size_t setups, const std::vector<std::pair<int, double>>& errors) {
  return adjusted(setups, errors).bad;
}

constexpr int kHeight = 10, kPlace = 13;  // of setup 2

TEST(BadSetups, AHeightIsBadBeyondWhatChanceAllowsUnderTheOthersDrawnToTwoMillimetres) {
  // three parameters at 0.3 %: 3.7 sigmas of 1.5 mm, and what the overlaps leave of the setup's tilt
  EXPECT_FALSE(badOf(6, {{kHeight, 0.0067}})[2]);
  EXPECT_TRUE(badOf(6, {{kHeight, 0.0079}})[2]);
}

TEST(BadSetups, APlaceIsBadBeyondWhatChanceAllowsUnderTheOthersDrawnToTwoMillimetres) {
  // two parameters at 0.3 %: 3.4 sigmas of 1.5 mm, and what the overlaps leave
  EXPECT_FALSE(badOf(6, {{kPlace, 0.0053}})[2]);
  EXPECT_TRUE(badOf(6, {{kPlace, 0.0063}})[2]);
}

TEST(BadSetups, PriorsAreLiftedBeyondWhatChanceAllowsUnderSigmasThatFewOthersTell) {
  // 0.3 % of the variance ratio with ten degrees of freedom, of two others drawn to 2 mm by three setups' worth
  EXPECT_TRUE(adjusted(3, {{kHeight, 0.0140}}).bad[2]);
  EXPECT_FALSE(adjusted(3, {{kHeight, 0.0140}}).freed[2]);
  EXPECT_TRUE(adjusted(3, {{kHeight, 0.0150}}).freed[2]);
  EXPECT_TRUE(adjusted(6, {{kHeight, 0.0085}}).freed[2]);
}

TEST(BadSetups, SurveysBadlyRegisteredHaveSigmasThatHoldTheirErrors) {
  constexpr int kTrials = 100;
  Recipe recipe;
  recipe.setups = 4;
  recipe.half_view = 70.0 * kPi / 180.0;
  recipe.sigma_error = 0.004;
  std::mt19937_64 random(6);
  double squares = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Survey survey = made(recipe, random);
    const SetupAdjustment adjustment = adjustSetups(survey.arcs, recipe.setups, {});
    const Eigen::RowVectorXd mean = derivatives(recipe, survey).colwise().mean();
    const double error = mean * (survey.errors - adjustment.errors);
    squares += error * error / (mean * adjustment.covariance * mean.transpose()) / kTrials;
  }
  EXPECT_LT(std::sqrt(squares), 1.3);
}

/// Whether a setup 20 mm too high is found that meets others only so far to either side of its middle.
bool isFoundWhereItMeetsOthersWithin(double degrees) {
  constexpr std::size_t kSetup = 2;
  Recipe recipe = withoutErrors();
  recipe.half_view = 80.0 * kPi / 180.0;
  std::mt19937_64 random(4);
  Survey survey = made(recipe, random);
  survey.errors[kHeight] += 0.020;
  look(recipe, survey, random);
  std::vector<ArcView> met;
  for (const ArcView& arc : survey.arcs) {
    const bool seen = std::count(arc.seen.setups.begin(), arc.seen.setups.end(), kSetup) > 0;
    const double off = std::remainder(arc.azimuth - kTwoPi * kSetup / 6.0, kTwoPi);
    if (!seen || std::abs(off) < degrees * kPi / 180.0) met.push_back(arc);
  }
  return adjustSetups(met, recipe.setups, {}).bad[kSetup];
}

TEST(BadSetups, WhatIsSeenInOnePlaceOnlyNamesNone) {
  EXPECT_FALSE(isFoundWhereItMeetsOthersWithin(4.5));
  EXPECT_TRUE(isFoundWhereItMeetsOthersWithin(9.0));
}

TEST(BadSetups, OneOfFourIsFound) { EXPECT_TRUE(badOf(4, {{kHeight, 0.010}})[2]); }

TEST(BadSetups, TwoOfTenAreFoundWhereThreeAreNoException) {
  const std::vector<std::pair<int, double>> two = {{10, 0.015}, {30, -0.015}};
  const std::vector<bool> found = badOf(10, two);
  for (std::size_t s = 0; s < 10; ++s) EXPECT_EQ(found[s], s == 2 || s == 6) << s;
  const std::vector<std::pair<int, double>> three = {{10, 0.020}, {30, -0.018}, {45, 0.017}};
  EXPECT_EQ(badOf(10, three), std::vector<bool>(10, false));
}

/// How far off counts by the square, under sigmas that the first's error raises while it is one of them.
TEST(BadSetups, ASecondLessThanHalfAsFarOffDoesNotHideTheFirst) {
  const std::vector<bool> first = badOf(6, {{10, 0.030}, {20, 0.0105}});
  for (std::size_t s = 0; s < 6; ++s) EXPECT_EQ(first[s], s == 2) << s;
  EXPECT_EQ(badOf(6, {{10, 0.030}, {20, 0.0125}}), std::vector<bool>(6, false));
}

TEST(SetupAdjustment, SetupsThatMeetNowhereAreAsGoodAsAGoodSurveyorsAre) {
  const SetupAdjustment adjusted = adjustSetups({}, 2, {});
  const Eigen::VectorXd sigmas = adjusted.covariance.diagonal().cwiseSqrt();
  constexpr double kUncertain = 1.2909944487;  // what is usual, itself
  EXPECT_NEAR(sigmas[0], kUncertain * 0.002, 1e-9);
  EXPECT_NEAR(toArcSeconds(sigmas[1]), kUncertain * 10.0, 1e-6);
  EXPECT_NEAR(sigmas[3], kUncertain * 0.002, 1e-9);
}

TEST(BadSetups, OfTwoThatDisagreeNoneIsTheException) { EXPECT_EQ(badOf(2, {{5, 0.030}}), std::vector<bool>(2, false)); }

/// Whether so many setups' sigmas come from their overlaps.
bool tellTheirSigmas(std::size_t setups) {
  Recipe recipe;
  recipe.setups = setups;
  recipe.half_view = 170.0 * kPi / 180.0;
  recipe.sigma_arc = 1e-6;
  std::mt19937_64 random(8);
  const SetupAdjustment adjusted = adjustSetups(made(recipe, random).arcs, setups, {});
  EXPECT_EQ(adjusted.height_estimated, adjusted.plan_estimated);
  return adjusted.height_estimated;
}

/// The overlaps tell every parameter of all setups but one: three of height and tilt and two of place a setup.
TEST(SetupAdjustment, SigmasAreEstimatedFromThreeParametersThatAreDetermined) {
  EXPECT_FALSE(tellTheirSigmas(2));
  EXPECT_TRUE(tellTheirSigmas(3));
}

}  // namespace tank_datum::bad_setups_test
