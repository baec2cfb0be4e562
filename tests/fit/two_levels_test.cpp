#include "fit/two_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tank_datum::two_levels_test {

/// So many values, this share of them about 1.0 and the others about 1.0 + apart, with a standard deviation of 1e-3.
std::vector<double> valuesOf(int count, double share, double apart) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0.0, 1e-3);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back((i < share * count ? 1.0 : 1.0 + apart) + normal(random));
  return values;
}

TEST(FitTwoLevels, FindsLevelsShareAndDeviation) {
  for (const double share : {0.2, 0.5, 0.8}) {
    const TwoLevels levels = fitTwoLevels(valuesOf(4000, share, 0.005));
    EXPECT_NEAR(levels.low, 1.0, 2e-4);
    EXPECT_NEAR(levels.apart(), 0.005, 2e-4);
    EXPECT_NEAR(levels.sigma, 1e-3, 5e-5);
    EXPECT_NEAR(levels.share, share, 0.02);
  }
}

TEST(FitTwoLevels, TheGainIsThatOfTheLikelihoods) {
  // levels so far apart that each value's own is certain: a value's density is half of its level's, so that of n values
  // the gain is n (log(s_all / s) - log 2)
  const std::vector<double> values = valuesOf(1000, 0.5, 0.02);
  const double all = std::hypot(0.01, 1e-3);
  EXPECT_NEAR(fitTwoLevels(values).gain / 1000.0, std::log(all / 1e-3) - std::log(2.0), 0.03);
}

TEST(FitTwoLevels, OneLevelGainsNothingWorthMentioning) { EXPECT_LT(fitTwoLevels(valuesOf(1000, 1.0, 0.0)).gain, 4.0); }

TEST(GainOfStrays, IsThatOfTheLikelihoods) {
  // 700 values of one level, 300 clear of it: each value's density is 0.7 of its level's, or 0.3 over the range
  std::vector<double> values = valuesOf(700, 1.0, 0.0);
  const double range = 1.11 - *std::min_element(values.begin(), values.end());
  double mean = 0.0, squares = 0.0;
  for (int i = 0; i < 300; ++i) values.push_back(1.01 + (i + 0.5) * 0.1 / 300.0);
  for (const double v : values) mean += v / 1000.0;
  for (const double v : values) squares += (v - mean) * (v - mean) / 1000.0;
  const double among = 0.7 * (std::log(0.7 / 1e-3) - 0.5) + 0.3 * std::log(0.3 / range * std::sqrt(2.0 * M_PI));
  EXPECT_NEAR(gainOfStrays(values) / 1000.0, among - (-0.5 * std::log(squares) - 0.5), 0.03);
  EXPECT_GT(gainOfStrays(values), fitTwoLevels(values).gain);
}

TEST(GainOfStrays, IsLessThanThatOfTwoLevelsWhereThereAreTwo) {
  for (const double share : {0.15, 0.5, 0.85}) {
    const std::vector<double> values = valuesOf(1000, share, 0.005);
    EXPECT_LT(gainOfStrays(values), fitTwoLevels(values).gain - 10.0) << share;
  }
}

TEST(FitTwoLevels, AValueBelongsToTheLikelierLevel) {
  TwoLevels levels;
  levels.share = 0.5, levels.low = 0.0, levels.high = 1.0, levels.sigma = 0.25;
  EXPECT_FALSE(levels.isHigh(0.49));
  EXPECT_TRUE(levels.isHigh(0.51));
  levels.share = 0.9;  // sigma^2 / apart * log(9) = 0.137 further up
  EXPECT_FALSE(levels.isHigh(0.63));
  EXPECT_TRUE(levels.isHigh(0.65));
}

}  // namespace tank_datum::two_levels_test
