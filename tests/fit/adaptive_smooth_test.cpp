#include "fit/adaptive_smooth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tank_datum::adaptive_smooth_test {

constexpr double kTurn = 6.283185307179586;

template <typename Shape>
std::vector<SeriesValue> series(Shape shape, double noise, int count = 360) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<SeriesValue> all;
  for (int i = 0; i < count; ++i) all.push_back({shape(i) + noise * normal(random), noise, 1.0});
  return all;
}

TEST(AdaptiveSmooth, AParabolaWithoutNoiseStays) {
  const auto shape = [](int i) { return 1e-4 * (i - 180) * (i - 180); };
  std::vector<SeriesValue> exact;
  for (int i = 0; i < 360; ++i) exact.push_back({shape(i), 0.01, 1.0});
  const auto smooth = smoothed(exact, 15);
  for (int i = 40; i < 320; ++i) EXPECT_NEAR(smooth[static_cast<std::size_t>(i)].value, shape(i), 1e-9);
}

TEST(AdaptiveSmooth, TheLargestOfManyNoisyValuesIsNotTakenForTheShapes) {
  const auto shape = [](int i) { return 10.0 * std::cos(2 * kTurn * i / 360); };
  const auto noisy = series(shape, 0.3);
  const auto smooth = smoothed(noisy, 15);
  const auto larger = [](const SeriesValue& a, const SeriesValue& b) { return a.value < b.value; };
  const double raw_bias = std::max_element(noisy.begin(), noisy.end(), larger)->value - 10.0;
  const auto largest = std::max_element(smooth.begin(), smooth.end(), larger);
  EXPECT_GT(raw_bias, 0.4);
  EXPECT_NEAR(largest->value, 10.0, 0.2);
  EXPECT_LT(largest->sigma, 0.15);
}

TEST(AdaptiveSmooth, AStepAndABuckleAreNotWashedOut) {
  const auto step = smoothed(series([](int i) { return i < 180 ? 0.0 : 5.0; }, 0.1), 15);
  EXPECT_NEAR(step[178].value, 0.0, 0.4);
  EXPECT_NEAR(step[181].value, 5.0, 0.4);
  const auto buckle =
      smoothed(series([](int i) { return 6.0 * std::exp(-0.5 * std::pow((i - 90) / 3.0, 2)); }, 0.1), 15);
  EXPECT_NEAR(buckle[90].value, 6.0, 0.25);
}

TEST(AdaptiveSmooth, SigmasAreHonestAndWidenWhereNeighboursShareTheirPoints) {
  const auto flat = [](int) { return 0.0; };
  auto given = series(flat, 1.0, 3600);
  double within = 0;
  for (const SeriesValue& v : smoothed(given, 15)) within += std::abs(v.value) < 2.0 * v.sigma;
  EXPECT_GT(within / 3600.0, 0.90);
  EXPECT_LT(within / 3600.0, 0.99);
  const double alone = smoothed(given, 4)[100].sigma;
  for (SeriesValue& v : given) v.shared = 4.0;
  EXPECT_GE(smoothed(given, 4)[100].sigma, std::min(1.0, 1.5 * alone));
}

TEST(AdaptiveSmooth, UnknownStaysUnknownAndIsNotReachedInto) {
  auto given = series([](int i) { return 0.01 * i; }, 0.01);
  for (std::size_t i = 100; i < 140; ++i) given[i].value = NAN;
  const auto smooth = smoothed(given, 15);
  for (std::size_t i = 100; i < 140; ++i) EXPECT_TRUE(std::isnan(smooth[i].value)) << i;
  EXPECT_EQ(smooth[140].value, given[140].value);  // nothing on the one side: as it was
  EXPECT_NEAR(smooth[150].value, 1.5, 0.02);
}

TEST(AdaptiveSmooth, NoValuesAreNone) {
  EXPECT_TRUE(smoothed({}, 15).empty());
  EXPECT_EQ(smoothed({{1.0, 0.1, 1.0}}, 15)[0].value, 1.0);
}

TEST(AdaptiveSmooth, FewerThanFiveValuesMakeNoParabola) {
  std::vector<SeriesValue> six(6, {0.0, 1.0, 1.0});
  EXPECT_NEAR(smoothed(six, 2)[2].sigma, std::sqrt(17.0 / 35.0), 1e-12);  // of the parabola through five
  six[1].value = NAN;
  EXPECT_EQ(smoothed(six, 2)[2].sigma, 1.0);
}

TEST(AdaptiveSmooth, AWindowHasToMeetTheValueWithinThreeStandardErrorsOfEach) {
  const auto sigmaWith = [](double value) {
    std::vector<SeriesValue> seven(7, {0.0, 1.0, 1.0});
    seven[3].value = value;
    return smoothed(seven, 2)[3].sigma;
  };
  const double share = 17.0 / 35.0;  // of the middle value in the parabola through five; also its variance
  const double apart = 3.0 * (1.0 + std::sqrt(share)) / (1.0 - share);
  EXPECT_LT(sigmaWith(0.9 * apart), 1.0);
  EXPECT_EQ(sigmaWith(1.1 * apart), 1.0);
}

TEST(BetweenValues, AreMeansOrTheOneThatIsKnown) {
  const std::vector<SeriesValue> series = {{1.0, 0.1, 1.0}, {3.0, 0.5, 1.0}, {NAN, NAN, 1.0}, {NAN, NAN, 1.0}};
  const auto value = [&](std::size_t place) {
    const BetweenValues at(series, place, 4);
    return at.known() ? at.mean(series, &SeriesValue::value) : -1.0;
  };
  EXPECT_EQ(value(0), 1.0);
  EXPECT_EQ(value(3), 2.5);
  EXPECT_EQ(value(7), 3.0);   // beside one that is not known
  EXPECT_EQ(value(9), -1.0);  // between two of them
  EXPECT_EQ(value(13), 1.0);  // before the first
  EXPECT_NEAR(BetweenValues(series, 1, 4).mean(series, &SeriesValue::sigma), 0.2, 1e-12);
}

}  // namespace tank_datum::adaptive_smooth_test
