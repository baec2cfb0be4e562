#include "core/rounding_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

/// Values over a range, rounded to a step; 0: not.
std::vector<double> valuesOver(double range, double step, int count, double from = 0.0) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(0.0, range);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double value = from + place(random);
    values.push_back(step > 0.0 ? std::round(value / step) * step : value);
  }
  return values;
}

TEST(RoundingStep, IsWhatAllGapsAreMultiplesOf) {
  EXPECT_NEAR(roundingStep(valuesOver(2.0, 0.001, 20'000)), 0.001, 1e-9);
  EXPECT_NEAR(roundingStep(valuesOver(2.0, 0.005, 20'000, 4e6)), 0.005, 1e-8);
  EXPECT_NEAR(roundingStep(valuesOver(2.0, 0.0003, 3'000)), 0.0003, 1e-9) << "a third of the steps are met";
}

TEST(RoundingStep, IsSeenThroughTheLastDigitOfFloat32) {
  std::vector<double> values = valuesOver(2.0, 0.001, 20'000, 100.0);
  for (double& value : values) value = static_cast<float>(value);  // to 8e-6
  EXPECT_NEAR(roundingStep(std::move(values)), 0.001, 2e-5);
}

TEST(RoundingStep, ValuesThatWereNotRoundedHaveNone) {
  EXPECT_EQ(roundingStep(valuesOver(2.0, 0.0, 20'000)), 0.0);
  EXPECT_EQ(roundingStep(valuesOver(2.0, 0.0, 21)), 0.0);
  EXPECT_EQ(roundingStep(std::vector<double>(1'000, 2.5)), 0.0);
  EXPECT_EQ(roundingStep({}), 0.0);
}

/// The step of values a step apart, but for some of a hundred gaps that are so many steps.
double stepWithOdd(double gap, int every) {
  std::vector<double> values(1, 0.0);
  for (int i = 1; i <= 100; ++i) values.push_back(values.back() + 0.001 * (i % every == 0 ? gap : 1.0));
  return roundingStep(std::move(values));
}

TEST(RoundingStep, NineOfTenGapsShowIt) {
  EXPECT_NEAR(stepWithOdd(2.5, 20), 0.001, 1e-9);
  EXPECT_EQ(stepWithOdd(2.5, 6), 0.0);
}

TEST(RoundingStep, AMultipleMayBeATenthOfAStepOff) {
  EXPECT_NEAR(stepWithOdd(2.07, 2), 0.001, 1e-9);
  EXPECT_EQ(stepWithOdd(2.15, 2), 0.0);
}

TEST(RoundingStep, TwentyGapsTell) {
  EXPECT_EQ(roundingStep(valuesOver(0.0185, 0.001, 2'000)), 0.0);
  EXPECT_NEAR(roundingStep(valuesOver(0.0215, 0.001, 2'000)), 0.001, 1e-9);
}

TEST(RoundingStep, EightStepsAreAGap) {
  std::vector<double> near, far;
  for (int i = 0; i < 50; ++i) {
    const int pair = i / 2, odd = i % 2;
    near.push_back(0.001 * (9 * pair + odd)), far.push_back(0.001 * (10 * pair + odd));
  }
  EXPECT_NEAR(roundingStep(near), 0.001, 1e-9);
  EXPECT_EQ(roundingStep(far), 0.0);
}

/// The error of the mean of many values that scatter so much, rounded to 1, over all that they may lie at.
double errorSeen(double scatter) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  double squares = 0.0;
  constexpr int kPlaces = 100, kValues = 20'000;
  for (int place = 0; place < kPlaces; ++place) {
    const double at = static_cast<double>(place) / kPlaces;
    double sum = 0.0;
    for (int i = 0; i < kValues; ++i) {
      const double value = at + scatter * normal(random);
      sum += std::round(value) - at;
    }
    squares += square(sum / kValues);
  }
  return std::sqrt(squares / kPlaces);
}

TEST(RoundingError, IsThatOfTheMeanOfManyValues) {
  EXPECT_EQ(roundingError(0.0, 1.0), 0.0);
  EXPECT_NEAR(roundingError(0.001, 0.0), 0.001 / std::sqrt(12.0), 1e-9);
  for (const double scatter : {0.02, 0.1, 0.2, 0.3}) {
    EXPECT_GT(roundingError(1.0, scatter), 0.95 * errorSeen(scatter)) << scatter;
    EXPECT_LT(roundingError(1.0, scatter), 1.35 * errorSeen(scatter) + 0.005) << scatter;
  }
}

TEST(Rounding, ValuesBetweenTwoStepsScatterByMoreThanTheyDidBefore) {
  const Rounding alone{1.0, HUGE_VAL}, known{1.0, 0.37};
  EXPECT_LT(alone.errorOf(0.74, 0.0), 0.001);
  EXPECT_NEAR(known.errorOf(0.74, 0.0), roundingError(1.0, 0.0), 1e-9);
  EXPECT_NEAR(alone.errorOf(0.5, 0.0), roundingError(1.0, std::sqrt(0.25 - 1.0 / 6.0)), 1e-9);
  EXPECT_NEAR(alone.errorOf(0.2, 0.3), roundingError(1.0, 0.3), 1e-9);
}

}  // namespace
}  // namespace tank_datum
