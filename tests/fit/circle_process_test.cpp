#include "fit/circle_process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::circle_process_test {

constexpr double kUsual = 0.03, kError = 0.005;

using Curve = std::function<double(double azimuth)>;

double level(double) { return 0.0; }

/// Values at 72 steps that err by `kError` about a curve.
std::vector<NoisyValue> seen(const Curve& curve, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> error(0.0, kError);
  std::vector<NoisyValue> series;
  for (int k = 0; k < 72; ++k) series.push_back({curve(k * 5.0 * kDegree) + error(random), kError, 0.0});
  return series;
}

struct Followed {
  double rms, over_sigma;  ///< of the errors, and of their ratios to the standard errors
  double sigma;            ///< on the average
};

/// Over the rings of twenty seeds.
Followed follow(const Curve& curve) {
  double squares = 0, ratios = 0, sigmas = 0, count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<ProcessValue> values = followCircle(seen(curve, seed), 0.0, kUsual);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double off = values[k].value - curve(static_cast<double>(k) * 5.0 * kDegree);
      squares += off * off, ratios += off * off / (values[k].sigma * values[k].sigma), sigmas += values[k].sigma,
          ++count;
    }
  }
  return {std::sqrt(squares / count), std::sqrt(ratios / count), sigmas / count};
}

Curve wave(double amplitude, int n) {
  return [=](double azimuth) { return amplitude * std::cos(n * azimuth - 0.7); };
}

TEST(FollowCircle, FindsWavesOfAnyLengthAndStatesItsErrors) {
  for (const int n : {1, 2, 5, 12, 36}) {
    const Followed f = follow(wave(0.02, n));
    EXPECT_LT(f.rms, n < 3 ? 0.5 * kError : kError) << n;
    EXPECT_NEAR(f.over_sigma, 1.0, 0.15) << n;
  }
}

TEST(FollowCircle, WhatIsLevelIsDrawnTogether) {
  const Followed f = follow(level);
  EXPECT_LT(f.rms, 0.2 * kError);
  EXPECT_LT(f.sigma, 0.3 * kError) << "of a wave that may be there unseen";
  EXPECT_GT(f.sigma, 0.15 * kError);
}

TEST(FollowCircle, AWaveSmallerThanTheErrorsIsSeenInAllOfThem) {
  const Followed f = follow(wave(0.4 * kError, 1));
  EXPECT_LT(f.rms, 0.3 * kError);
  EXPECT_LT(f.over_sigma, 1.1);
}

TEST(FollowCircle, AmplitudesAreWhatTheCallerSays) {
  std::vector<NoisyValue> few(72, {kUnknown, 0.0, 0.0});
  few[0] = {0.0, 10.0, 0.0};  // tells nothing
  // of six amplitudes, each half of the one before and the last none, and two that are larger and less likely
  const double expected = kUsual * std::sqrt((2.0 + 1.0 + 1.0 / 4 + 1.0 / 16 + 1.0 / 64 + 1.0 / 256) / 6.3125);
  EXPECT_NEAR(followCircle(few, 0.0, kUsual)[30].sigma, expected, 1e-3 * expected);
}

TEST(FollowCircle, WhatNeighboursErrByAlikeIsNoWave) {
  const Curve arc = [](double azimuth) { return azimuth < 1.0 ? 0.02 : 0.0; };
  std::vector<NoisyValue> series = seen(arc);
  EXPECT_NEAR(followCircle(series, 0.0, kUsual)[6].value, 0.02, 0.006);
  for (std::size_t k = 0; k < 12; ++k) series[k].alike = 0.02;
  EXPECT_LT(std::abs(followCircle(series, 0.0, kUsual)[6].value), 0.012);
}

/// How much of a wave of so many lengths round the circle is followed, where values err alike by as much.
double shareFollowed(int lengths) {
  const Curve curve = wave(0.02, lengths);
  std::vector<NoisyValue> series;
  for (int k = 0; k < 72; ++k) series.push_back({curve(k * 5.0 * kDegree), 0.003, 0.02});
  const std::vector<ProcessValue> values = followCircle(series, 0.0, kUsual);
  double sum = 0;
  for (std::size_t k = 0; k < 72; ++k) sum += values[k].value * curve(static_cast<double>(k) * 5.0 * kDegree);
  return sum / (36.0 * 0.02 * 0.02);
}

TEST(FollowCircle, WhatChangesWithinARadianIsNotAlike) {
  EXPECT_LT(shareFollowed(3), 0.2);
  EXPECT_GT(shareFollowed(5), 0.5);
}

TEST(FollowCircle, WhatValuesMayErrByBesidesIsNoWaveThatTheyShow) {
  const Curve fast = wave(0.014, 12);
  double squares = 0, ratios = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<ProcessValue> values = followCircle(seen(fast, seed), 0.01, kUsual);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double off = values[k].value - fast(static_cast<double>(k) * 5.0 * kDegree);
      squares += off * off / 1440.0, ratios += off * off / (values[k].sigma * values[k].sigma) / 1440.0;
    }
  }
  EXPECT_LT(std::sqrt(squares), kError);
  EXPECT_NEAR(std::sqrt(ratios), 1.0, 0.2);
}

/// Root mean square of what is followed of values that err by 0.01 about nothing, but say so of so much of it only.
double followedOfNoise(double common) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> error(0.0, 0.01);
  double squares = 0;
  for (int i = 0; i < 20; ++i) {
    std::vector<NoisyValue> series;
    for (int k = 0; k < 72; ++k) series.push_back({error(random), 0.001, 0.0});
    for (const ProcessValue& v : followCircle(series, common, kUsual)) squares += v.value * v.value / 1440.0;
  }
  return std::sqrt(squares);
}

TEST(FollowCircle, ValuesMayErrByMoreThanTheySay) {
  EXPECT_GT(followedOfNoise(0.0), 0.009);
  EXPECT_LT(followedOfNoise(0.01), 0.002);
  EXPECT_LT(followedOfNoise(0.02), 0.002) << "by half of that";
}

TEST(FollowCircle, FollowsWhereNoValueIsKnown) {
  std::vector<NoisyValue> series = seen(wave(0.02, 1));
  for (std::size_t k = 20; k < 26; ++k) series[k].value = kUnknown;
  const std::vector<ProcessValue> values = followCircle(series, 0.0, kUsual);
  EXPECT_NEAR(values[23].value, wave(0.02, 1)(115.0 * kDegree), 0.006);
  EXPECT_GT(values[23].sigma, values[50].sigma);
}

TEST(FollowCircle, NoValueAtAllTellsNothing) {
  const std::vector<ProcessValue> values = followCircle({{kUnknown, 1.0, 0.0}, {kUnknown, 1.0, 0.0}}, 0.0, kUsual);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[1].value, 0.0);
  EXPECT_EQ(values[1].sigma, kUsual);
}

}  // namespace tank_datum::circle_process_test
