#include "core/rounding_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/portable_math.h"

namespace tank_datum::rounding_step_test {

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

constexpr double kFinest = 0.0002;

double stepOf(std::vector<double> values) { return roundingStep(std::move(values), kFinest); }

TEST(RoundingStep, IsWhatAllGapsAreMultiplesOf) {
  EXPECT_NEAR(stepOf(valuesOver(2.0, 0.001, 20'000)), 0.001, 1e-9);
  EXPECT_NEAR(stepOf(valuesOver(2.0, 0.005, 20'000, 4e6)), 0.005, 1e-8);
  EXPECT_NEAR(stepOf(valuesOver(2.0, 0.001, 1'000)), 0.001, 1e-9) << "a third of the steps are met";
  EXPECT_EQ(stepOf(valuesOver(2.0, 0.00015, 20'000)), 0.0) << "finer than is asked for";
}

TEST(RoundingStep, IsSeenThroughTheLastDigits) {
  std::vector<double> values = valuesOver(2.0, 0.001, 20'000, 1600.0), sums = valuesOver(2.0, 0.001, 20'000);
  for (double& value : values) value = static_cast<float>(value);  // to 0.00012
  for (std::size_t i = 0; i < sums.size(); i += 2) sums[i] = (sums[i] + 1000.1) - 1000.1;
  EXPECT_NEAR(stepOf(std::move(values)), 0.001, 3e-5);
  EXPECT_NEAR(stepOf(std::move(sums)), 0.001, 1e-6);
}

TEST(RoundingStep, ValuesAHundredthOfTheFinestStepApartAreAlike) {
  const auto apart = [](double by) {
    std::vector<double> values;
    for (int i = 0; i < 800; ++i) values.push_back(0.001 * (i % 100) + by * (i / 100));
    return stepOf(std::move(values));
  };
  EXPECT_NEAR(apart(1.5e-6), 0.001, 1e-6);
  EXPECT_EQ(apart(3e-6), 0.0);
}

TEST(RoundingStep, ValuesThatWereNotRoundedHaveNone) {
  for (const int count : {3, 21, 300, 3'000, 20'000, 100'000}) EXPECT_EQ(stepOf(valuesOver(2.0, 0.0, count)), 0.0);
  EXPECT_EQ(stepOf(std::vector<double>(1'000, 2.5)), 0.0);
  EXPECT_EQ(stepOf({}), 0.0);
}

/// A filter that takes the mean of what a voxel holds leaves values on the steps, and as many anywhere between.
TEST(RoundingStep, IsThatOfTheLevelsThatMostValuesShare) {
  std::vector<double> values;
  for (int i = 0; i < 6'000; ++i) values.push_back(0.01 * (i % 60));
  for (int of = 2; of <= 40; ++of) {
    for (int i = 0; i < 240; ++i) values.push_back(0.01 * (i % 60) + 0.01 * (i % of) / of);
  }
  EXPECT_NEAR(stepOf(values), 0.01, 1e-9);
}

/// So many values on one level, of a floor, and as many on forty levels, of a wall, so many steps apart; means lie
/// between.
std::vector<double> valuesAboutFloor(int apart, int on_floor = 5'000) {
  std::vector<double> values(static_cast<std::size_t>(on_floor), 0.0);
  for (int i = 0; i < 40; ++i) values.insert(values.end(), 100, 0.01 * (1 + apart * i));
  for (int of = 2; of <= 40; ++of) {
    for (int i = 0; i < 240; ++i) values.push_back(0.01 * (i % 60) + 0.01 * (i % of) / of);
  }
  return values;
}

TEST(RoundingStepBesideFloor, IsThatOfTheFullestLevelsHoweverFarApart) {
  EXPECT_NEAR(roundingStepBesideFloor(valuesAboutFloor(1), kFinest), 0.01, 1e-9);
  EXPECT_NEAR(roundingStepBesideFloor(valuesAboutFloor(30), kFinest), 0.01, 1e-9) << "one gap is of one step";
  EXPECT_EQ(stepOf(valuesAboutFloor(30)), 0.0);
}

TEST(RoundingStepBesideFloor, OfValuesThatWereNotRoundedIsNone) {
  for (const int count : {3, 21, 300, 20'000}) {
    EXPECT_EQ(roundingStepBesideFloor(valuesOver(2.0, 0.0, count), kFinest), 0.0);
    EXPECT_EQ(roundingStepBesideFloor(std::vector<double>(static_cast<std::size_t>(count), 1.0), kFinest), 0.0);
  }
  EXPECT_EQ(roundingStepBesideFloor({}, kFinest), 0.0);
}

TEST(RoundingStep, AFifthOfTheValuesMayBeRounded) {
  const auto with_others = [](int rounded) {
    std::vector<double> values = valuesOver(0.5, 0.001, rounded), others = valuesOver(0.5, 0.0, 20'000 - rounded);
    values.insert(values.end(), others.begin(), others.end());
    return stepOf(std::move(values));
  };
  EXPECT_NEAR(with_others(19'000), 0.001, 1e-9);
  EXPECT_NEAR(with_others(6'000), 0.001, 1e-5);
  EXPECT_EQ(with_others(2'000), 0.0);
}

/// The step of levels a step apart, five values each, but for some of a hundred gaps that are so many steps.
double stepWithOdd(double gap, int every) {
  std::vector<double> values(5, 0.0);
  for (int i = 1; i <= 100; ++i) values.insert(values.end(), 5, values.back() + 0.001 * (i % every == 0 ? gap : 1.0));
  return stepOf(std::move(values));
}

TEST(RoundingStep, NineOfTenGapsShowIt) {
  EXPECT_NEAR(stepWithOdd(2.5, 20), 0.001, 1e-9);
  EXPECT_EQ(stepWithOdd(2.5, 6), 0.0);
}

TEST(RoundingStep, AMultipleMayBeAFifthOfAStepOff) {
  EXPECT_NEAR(stepWithOdd(2.15, 2), 0.001, 1e-9);
  EXPECT_EQ(stepWithOdd(2.3, 2), 0.0);
}

TEST(RoundingStep, EightStepsAreAGap) {
  EXPECT_NEAR(stepWithOdd(8.0, 2), 0.001, 1e-9);
  EXPECT_EQ(stepWithOdd(9.0, 2), 0.0);
}

TEST(RoundingStep, FourLevelsTell) {
  const auto levels = [](int count) {
    std::vector<double> values;
    for (int i = 0; i < 10 * count; ++i) values.push_back(0.001 * (i % count));
    return stepOf(std::move(values));
  };
  EXPECT_EQ(levels(3), 0.0);
  EXPECT_NEAR(levels(4), 0.001, 1e-9);
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

}  // namespace tank_datum::rounding_step_test
