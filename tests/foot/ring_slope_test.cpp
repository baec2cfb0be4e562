#include "foot/ring_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum::ring_slope_test {

constexpr double kError = 0.006, kLean = 0.05;
constexpr ExpectedSlope kLevel{0.0, 0.0, 0.0};

/// Standard error of the slopes of 72 windows, every third seen so steeply that beams feign nothing, which differ from
/// those of the ring by their errors times so much; the others, times that, lie below.
double sigmaWhere(double best, double others) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<SeriesValue> seen, series;
  for (int k = 0; k < 72; ++k) {
    const bool steep = k % 3 == 0;
    const double off = kError * normal(random);
    seen.push_back({steep ? best * off : -std::abs(others * off), kError, 1.0});
    series.push_back(seen.back());
    if (!steep) series.back().sigma = std::hypot(kError, kLean);
  }
  return drawTogether(seen, series, 0.0, kLevel).windows.front().sigma;
}

TEST(DrawTogether, SlopesDifferByWhatTheyShow) {
  EXPECT_LT(sigmaWhere(1.0, 1.0), 0.6 * kError);
  EXPECT_GT(sigmaWhere(2.0, 2.0), 0.8 * kError);
}

TEST(DrawTogether, WhatBeamsFeignMakesNoSlopesDiffer) { EXPECT_LT(sigmaWhere(1.0, 6.0), 0.6 * kError); }

TEST(DrawTogether, SlopesThatDifferLittleMayDifferUnseen) {
  EXPECT_LT(sigmaWhere(0.2, 0.2), 0.2 * kError);
  EXPECT_GT(sigmaWhere(0.2, 0.2), 0.1 * kError);
}

/// The slope as it is drawn among so many windows beside each other that show it so far off the ring's, of which beams
/// may feign kLean.
double slopeOff(int windows, double off, double rise_beyond = 0.0) {
  std::vector<SeriesValue> seen, series;
  for (int k = 0; k < 72; ++k) {
    const bool in = std::abs(2 * (k - 30)) < windows;
    seen.push_back({in ? off : 0.0, kError, 1.0});
    series.push_back(seen.back());
    if (k >= 20 && k <= 40) series.back().sigma = std::hypot(kError, kLean);
  }
  return drawTogether(seen, series, 0.0, {0.0, 0.0, 0.0, rise_beyond}).windows[30].value;
}

TEST(DrawTogether, BeamsFeignNoRise) {
  EXPECT_GT(slopeOff(19, 1.6 * kError), 1.0 * kError);  // five windows know it to 0.45 of their errors
  EXPECT_LT(slopeOff(19, 1.1 * kError), 0.5 * kError);
  EXPECT_LT(slopeOff(1, 4.0 * kError), 0.5 * kError);  // by chance
  EXPECT_GT(slopeOff(3, 2.7 * kError), 0.5 * kError);
  EXPECT_GT(slopeOff(19, -2.5 * kError), -1.0 * kError);
  EXPECT_LT(slopeOff(19, 2.5 * kError, 0.01), 1.0 * kError);  // but before a crown
}

/// The ring's slope where all windows show level lips on what falls by so much, and beams may feign as much down.
MeanSlope levelOn(double falls, double lean) {
  const std::vector<SeriesValue> seen(72, {0.0, 0.001, 1.0});
  return drawTogether(seen, seen, 0.0, {-falls, 0.0005, lean}).ring;
}

TEST(DrawTogether, LipsThatAreSeenLevelOnAShoulderThatFallsLeanNoLess) {
  for (const double lean : {0.02, 0.12, 0.3}) {
    const MeanSlope ring = levelOn(0.08, lean);
    EXPECT_NEAR(ring.slope, 0.0, 0.001) << lean;
    constexpr double kTank = 0.03;  // of lips about what they lie on
    const double beams = 0.6 * lean;
    double weights = 0.0, squares = 0.0;  // of what beams draw down: never up
    for (double b = 0.0; b < 0.2; b += 1e-5) {
      const double weight = std::exp(-0.5 * (square((0.08 + b) / kTank) + square(b / beams)));
      weights += weight, squares += weight * b * b;
    }
    const double drawn = std::sqrt(squares / weights);
    EXPECT_NEAR(ring.sigma, 1.0 / std::hypot(1.0 / drawn, 1.0 / kTank), 2e-4) << lean;
  }
  EXPECT_LT(levelOn(0.09, 4.0).sigma, 0.015) << "a normal distribution's tail that no number holds";
}

/// Slopes of 72 windows, the first of which lies off by so much; of the second as they are drawn.
double besideOneOff(double off) {
  std::vector<SeriesValue> seen(72, {0.0, 0.01, 1.0});
  seen[0].value = off;
  return drawTogether(seen, seen, 0.0, kLevel).windows[1].value;
}

TEST(DrawTogether, AWindowFartherOffThanAnyLipDrawsNoOther) {
  EXPECT_GT(besideOneOff(0.095), 0.001);
  EXPECT_LT(besideOneOff(0.105), 0.0001);
}

TEST(DrawTogether, SlopesThatChangeAlongTheRingAreFollowed) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  const auto slopeAt = [](int k) { return 0.02 * std::cos(2.0 * k * kTwoPi / 72.0); };
  std::vector<SeriesValue> seen;
  for (int k = 0; k < 72; ++k) {
    const double error = k % 5 == 0 ? kError : 5.0 * kError;  // few are seen well
    seen.push_back({slopeAt(k) + error * normal(random), error, 1.0});
  }
  const std::vector<SeriesValue> windows = drawTogether(seen, seen, 0.0, kLevel).windows;
  double squares = 0;
  for (int k = 0; k < 72; ++k) squares += std::pow(windows[static_cast<std::size_t>(k)].value - slopeAt(k), 2) / 72.0;
  EXPECT_LT(std::sqrt(squares), kError);
}

TEST(DrawTogether, SlopesThatNothingTellsMayDifferByAHundredAndFifty) {
  const std::vector<SeriesValue> seen(72, {0.0, 1.0, 1.0});
  EXPECT_NEAR(drawTogether(seen, seen, 0.0, kLevel).windows[5].sigma, 0.015 * std::sqrt(3.333 / 6.3125), 0.0007);
}

/// The ring's slope where its windows fall by 0.01, of which beams may feign all, and what the lips lie on is level,
/// known to that.
MeanSlope ringOnLevel(double sigma) {
  const std::vector<SeriesValue> seen(72, {-0.01, 0.004, 1.0});
  return drawTogether(seen, seen, 0.0, {0.0, 0.0, 0.01, 0.0, sigma}).ring;
}

TEST(DrawTogether, WhatTheLipsLieOnTellsTheirSlopeAsFarAsItIsKnown) {
  EXPECT_GT(ringOnLevel(0.0).slope, -0.0015);
  EXPECT_LT(ringOnLevel(0.01).slope, -0.003);
  EXPECT_GT(ringOnLevel(0.01).sigma, ringOnLevel(0.0).sigma);
}

TEST(DrawTogether, WhatBeamsMayFeignOfEachWindowIsNoErrorOfAllTogether) {
  const std::vector<SeriesValue> seen(72, {-0.0135, 0.0045, 1.0}), series(72, {-0.0135, 0.05, 1.0});
  const MeanSlope ring = drawTogether(seen, series, 0.0, {0.0, 1e-4, 0.001}).ring;
  EXPECT_NEAR(ring.slope, -0.0135, 0.0010) << "their edges show that beams feign 0.001 at most";
  EXPECT_LT(ring.sigma, 0.0015);
}

TEST(DrawTogether, OfWhatBeamsMayFeignBesidesSixTenthsAreDoubted) {
  const std::vector<SeriesValue> seen(72, {0.0, 1e-5, 1.0});
  const double sigma = drawTogether(seen, seen, 0.0, {0.0, 1e-4, 0.0, 0.02}).ring.sigma;
  EXPECT_NEAR(sigma, 1.0 / std::hypot(1.0 / 0.012, 1.0 / 0.03), 1e-5);
}

}  // namespace tank_datum::ring_slope_test
