#include "setups/setup_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "setups/setup_adjustment.h"
#include "support/made_overlaps.h"

namespace tank_datum::setup_groups_test {

using namespace made_overlaps;

/// Two groups of so many setups, whose heights scatter by 0.1 mm and differ by some standard deviations.
std::vector<double> grouped(int lower, int upper, double apart) {
  std::vector<double> heights;
  for (int k = 0; k < lower; ++k) heights.push_back(k % 2 == 0 ? -0.0001 : 0.0001);
  for (int k = 0; k < upper; ++k) heights.push_back(apart * 0.0001 + (k % 2 == 0 ? -0.0001 : 0.0001));
  return heights;
}

TEST(SetupGroups, AreFartherApartThanChanceMakesThem) {
  // of 12 by 7.0 standard deviations, of four by 31; over what those of a group scatter by
  EXPECT_TRUE(twoGroups(grouped(6, 6, 8.5)).found());
  EXPECT_FALSE(twoGroups(grouped(6, 6, 7.0)).found());
  EXPECT_TRUE(twoGroups(grouped(2, 2, 48.0)).found());
  EXPECT_FALSE(twoGroups(grouped(2, 2, 40.0)).found());
}

TEST(SetupGroups, SetupsThatErrIndependentlyAreHardlyEverOfTwo) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0.0, 0.002);
  for (const int setups : {4, 6, 8, 12, 20}) {
    int found = 0;
    for (int survey = 0; survey < 4000; ++survey) {
      std::vector<double> heights(static_cast<std::size_t>(setups));
      for (double& height : heights) height = normal(random);
      found += twoGroups(heights).found();
    }
    EXPECT_LT(found, 24) << setups << " setups";
  }
}

TEST(SetupGroups, OneSetupIsNone) {
  EXPECT_FALSE(twoGroups(grouped(5, 1, 1000.0)).found());
  EXPECT_FALSE(twoGroups(grouped(1, 2, 1000.0)).found());
  EXPECT_TRUE(twoGroups(grouped(5, 2, 1000.0)).found());
  EXPECT_EQ(twoGroups(grouped(1, 2, 1000.0)).higher, std::vector<bool>(3, false));
}

TEST(SetupGroups, NameTheHigherOnesOfThoseThatAreCompared) {
  std::vector<double> heights = grouped(3, 3, 100.0);
  heights.insert(heights.begin(), kUnknown);
  const SetupGroups groups = twoGroups(heights);
  EXPECT_NEAR(groups.apart, 0.010, 1e-4);
  EXPECT_EQ(groups.higher, (std::vector<bool>{false, false, false, false, true, true, true}));
  EXPECT_EQ(groups.lower, (std::vector<bool>{false, true, true, true, false, false, false}));
}

/// Setups that see far round the ring, and err by next to nothing.
Recipe farSeeing(std::size_t setups) {
  Recipe recipe;
  recipe.setups = setups;
  recipe.half_view = 100.0 * kDegree;
  recipe.sigma_error = recipe.sigma_plan = 0.0001, recipe.sigma_tilt = 1e-7;
  return recipe;
}

/// Eight of them, every other one of a survey higher by 5 mm.
SetupAdjustment twoSurveys(double bad_height = 0.0) {
  const Recipe recipe = farSeeing(8);
  std::mt19937_64 random(4);
  Survey survey = made(recipe, random);
  for (Eigen::Index s = 0; s < 8; s += 2) survey.errors[5 * s] += 0.005;
  survey.errors[5] += bad_height;
  look(recipe, survey, random);
  return adjustSetups(survey.arcs, recipe.setups, {});
}

TEST(SetupGroups, OfTwoSurveysHalfOfTheDifferenceIsInWhatAllErrBy) {
  const SetupAdjustment adjusted = twoSurveys();
  EXPECT_NEAR(adjusted.groups.apart, 0.005, 2e-4);
  double least = 1.0;
  for (Eigen::Index row = 0; row < 40; row += 5) {
    for (Eigen::Index column = 0; column < 40; column += 5) least = std::min(least, adjusted.covariance(row, column));
  }
  EXPECT_GT(std::sqrt(least), 0.0024);
  EXPECT_LT(std::sqrt(least), 0.0040);
}

TEST(SetupGroups, AsManyAsMayBeBadAreBad) {
  const auto adjustedOf = [](std::size_t setups, double apart) {
    const Recipe recipe = farSeeing(setups);
    std::mt19937_64 random(4);
    Survey survey = made(recipe, random);
    survey.errors[10] += apart, survey.errors[15] += apart;  // side by side
    look(recipe, survey, random);
    return adjustSetups(survey.arcs, setups, {});
  };
  const SetupAdjustment ten = adjustedOf(10, 0.060);
  EXPECT_TRUE(ten.bad[2] && ten.bad[3]);
  EXPECT_FALSE(ten.groups.found());
  EXPECT_NEAR(ten.errors[0], 0.0, 0.001);
  EXPECT_NEAR(ten.errors[10], 0.060, 0.002);
  const SetupAdjustment nine = adjustedOf(9, 0.060);
  EXPECT_FALSE(nine.bad[2] && nine.bad[3]);
  EXPECT_NEAR(nine.groups.apart, 0.060, 0.003);
  EXPECT_TRUE(adjustedOf(10, 0.009).bad[2]);
  const SetupAdjustment near = adjustedOf(10, 0.0045);
  EXPECT_FALSE(near.bad[2]) << "no farther off than is usual";
  EXPECT_NEAR(near.groups.apart, 0.0045, 0.0003);
}

TEST(SetupGroups, ABadSetupIsOfNoGroup) {
  const SetupAdjustment adjusted = twoSurveys(0.200);
  ASSERT_TRUE(adjusted.bad[1]);
  EXPECT_FALSE(adjusted.groups.higher[1]);
}

}  // namespace tank_datum::setup_groups_test
