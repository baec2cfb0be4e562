#include "fit/ring_process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/statistics.h"
#include "fit/ring_scatter.h"

namespace tank_datum::ring_process_test {

constexpr std::size_t kCount = 360;
constexpr double kSigma = 0.0003, kFlexible = 0.005;

using Shape = double (*)(double degrees);

double quiet(double degrees) { return 0.004 * std::cos(2.0 * degrees * M_PI / 180.0); }

/// 6 mm deep, 12 degrees from rim to rim.
double dipped(double degrees) {
  const double off = std::abs(degrees - 120.0);
  return quiet(degrees) - (off < 6.0 ? 0.006 * std::pow(std::cos(M_PI * off / 12.0), 4) : 0.0);
}

struct Ring {
  std::vector<double> truth, values, sigmas;

  explicit Ring(Shape shape, double noise = kSigma, unsigned seed = 1) : sigmas(kCount, kSigma) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < kCount; ++i) {
      truth.push_back(shape(static_cast<double>(i)));
      values.push_back(truth.back() + noise * normal(random));
    }
  }
  RingProcess followed() const { return followRing(values, sigmas, kFlexible); }
  double error(const RingProcess& process, std::size_t i) const { return process.value[i] - truth[i]; }
};

double rmsOf(const Ring& ring, const RingProcess& process) {
  double squares = 0;
  for (std::size_t i = 0; i < kCount; ++i) squares += std::pow(ring.error(process, i), 2) / kCount;
  return std::sqrt(squares);
}

TEST(RingProcess, NeighboursHelpAndSigmaKnowsIt) {
  const Ring ring(quiet);
  const RingProcess process = ring.followed();
  ASSERT_TRUE(process.valid());
  EXPECT_LT(rmsOf(ring, process), 0.7 * kSigma);
  std::size_t within = 0;
  for (std::size_t i = 0; i < kCount; ++i) within += std::abs(ring.error(process, i)) < 2.0 * process.sigma[i];
  EXPECT_GT(within, kCount * 90 / 100);
  EXPECT_LT(median(process.sigma), 1.5 * rmsOf(ring, process));
}

TEST(RingProcess, ScatterIsNoLessThanDifferencesShowBeyondChance) {
  const Ring ring(quiet, 2.0 * kSigma);
  // a process this free follows all scatter but what it may not
  const RingProcess process = followRing(ring.values, ring.sigmas, 0.2);
  const double shown = ringScatter(ring.values, ring.sigmas) / (1.0 + 2.6 / std::sqrt(360.0));
  EXPECT_NEAR(process.nugget, kSigma * std::sqrt(shown * shown - 1.0), 0.03 * kSigma);
}

/// Every fifth value on half the ring: they are too few for their differences to tell.
TEST(RingProcess, ErrorsThatCannotBeJudgedStandAsGiven) {
  Ring ring(quiet, 0.3 * kSigma);
  const auto withEvery = [&](std::size_t stride) {
    Ring some = ring;
    for (std::size_t i = 0; i < kCount; ++i)
      if (i % stride != 0 || i > kCount / 2) some.values[i] = std::numeric_limits<double>::quiet_NaN();
    return some.followed().scale;
  };
  EXPECT_LT(withEvery(1), 0.6);
  EXPECT_EQ(withEvery(5), 1.0);
}

TEST(RingProcess, AShortDipIsNotSmoothedAway) {
  const Ring ring(dipped);
  const RingProcess process = ring.followed();
  for (std::size_t i = 110; i <= 130; ++i) EXPECT_NEAR(ring.error(process, i), 0.0, 4.0 * process.sigma[i]) << i;
  EXPECT_NEAR(ring.error(process, 120), 0.0, 0.0008);
}

TEST(RingProcess, AProcessWithoutFreedomWouldSmoothIt) {
  const Ring ring(dipped);
  const RingProcess stiff = followRing(ring.values, ring.sigmas, 1e-7);
  EXPECT_GT(std::abs(ring.error(stiff, 120)), 0.001);
}

/// Values that scatter in one place by so many of their standard errors, every second one up.
Ring scatteredAt120(double errors) {
  Ring ring(quiet);
  for (std::size_t i = 116; i <= 124; ++i) ring.values[i] = ring.truth[i] + (i % 2 == 0 ? errors : -errors) * kSigma;
  return ring;
}

TEST(RingProcess, ValuesThatScatterMoreInOnePlaceAreNoBend) {
  const Ring ring = scatteredAt120(3.0);
  const RingProcess process = ring.followed();
  for (const std::size_t i : {120U, 121U}) EXPECT_LT(std::abs(ring.error(process, i)), 0.2 * kSigma);
  EXPECT_GT(process.sigma[120], 1.4 * kSigma);
  EXPECT_LT(scatteredAt120(2.0).followed().sigma[120], 1.3 * kSigma);
}

TEST(RingProcess, AStrayValueCountsForWhatItIsOff) {
  Ring ring(quiet);
  ring.values[50] += 0.010;
  const RingProcess process = ring.followed();
  EXPECT_GT(process.doubt[50], 4.0);
  EXPECT_LT(std::abs(ring.error(process, 50)), 0.0006);
  EXPECT_NEAR(process.sigma[50], 0.3 * 0.010, 0.0005);  // it may be right
  EXPECT_NEAR(process.strayed[50], 0.010, 0.001);
  EXPECT_EQ(process.strayed[49], 0.0);
  EXPECT_NEAR(process.sigmaOfFollowed(50), process.sigma[60], 0.0001);
  EXPECT_LT(process.sigma[60], 0.0003);
}

TEST(RingProcess, ScatterBeyondTheGivenErrorsIsFoundFromTheValues) {
  const Ring rough(quiet, 3.0 * kSigma), fine(quiet, 0.5 * kSigma);
  const RingProcess more = rough.followed(), less = fine.followed();
  EXPECT_GT(median(more.sigma), 2.0 * median(less.sigma));
  EXPECT_NEAR(std::hypot(kSigma, more.nugget), 3.0 * kSigma, 0.6 * kSigma);
  EXPECT_EQ(more.scale, 1.0);
  EXPECT_NEAR(less.scale, 0.5, 0.1);
}

TEST(RingProcess, SigmaKnowsWhatNeighboursShare) {
  Ring ring(quiet);
  const std::vector<double> alone = ring.values;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::size_t next = (i + 1) % kCount;
    ring.values[i] = ring.truth[i] + std::sqrt(0.5) * (alone[i] - ring.truth[i] + alone[next] - ring.truth[next]);
  }
  const RingProcess process = ring.followed();
  EXPECT_NEAR(median(process.sigma), rmsOf(ring, process), 0.25 * rmsOf(ring, process));
}

TEST(RingProcess, GapsAreBridgedWithALargerError) {
  Ring ring(quiet);
  for (std::size_t i = 200; i < 208; ++i) ring.values[i] = ring.sigmas[i] = NAN;
  const RingProcess process = ring.followed();
  EXPECT_GT(process.sigma[204], 2.0 * process.sigma[190]);
  EXPECT_NEAR(ring.error(process, 204), 0.0, 3.0 * process.sigma[204]);
}

/// Waves of 10 mm, which nothing tells over half the ring.
TEST(RingProcess, SigmaHoldsWhatWavesDoInLongGaps) {
  const auto waves = [](double degrees) {
    const double t = degrees * M_PI / 180.0;
    return 0.010 * (std::cos(t) + std::cos(2.0 * t + 1.0) + std::cos(3.0 * t + 2.0) + std::cos(4.0 * t + 3.0));
  };
  Ring ring(waves);
  for (std::size_t i = 181; i < kCount; ++i) ring.values[i] = ring.sigmas[i] = NAN;
  const RingProcess process = ring.followed();
  for (std::size_t i = 181; i < kCount; ++i) EXPECT_LT(std::abs(ring.error(process, i)), 3.0 * process.sigma[i]) << i;
  EXPECT_GT(process.sigma[270], 0.05);
  EXPECT_GT(std::abs(ring.error(process, 270)), 3.0 * process.amplitude);
  EXPECT_LE(process.sigmaOfFollowed(270), 1.001 * process.amplitude) << "a station there is told by what it follows";
}

TEST(RingProcess, WavesAreNotHigherThanAMetre) {
  Ring ring(quiet);
  for (std::size_t i = 8; i < kCount; ++i) ring.values[i] = ring.sigmas[i] = NAN;
  EXPECT_NEAR(ring.followed().sigma[184], 2.0, 0.4);  // of nine coefficients, whose sum at the values is known
}

TEST(RingProcess, TheRingHasNoEnds) {
  Ring ring(quiet), turned(quiet);
  for (std::size_t i = 0; i < kCount; ++i) turned.values[(i + 123) % kCount] = ring.values[i];
  const RingProcess a = ring.followed(), b = turned.followed();
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(a.value[i], b.value[(i + 123) % kCount], 2e-5);
}

TEST(RingProcess, FewerThanEightValuesFollowNothing) {
  Ring ring(quiet);
  for (std::size_t i = 7; i < kCount; ++i) ring.values[i] = ring.sigmas[i] = NAN;
  EXPECT_FALSE(ring.followed().valid());
}

TEST(RingProcess, EightValuesAreFollowed) {
  Ring ring(quiet);
  for (std::size_t i = 8; i < kCount; ++i) ring.values[i] = ring.sigmas[i] = NAN;
  EXPECT_TRUE(ring.followed().valid());
}

/// A ring without noise, two neighbouring values off by so many times what the values are taken to scatter.
RingProcess withStrays(double first, double second) {
  constexpr double kScatter = 0.4 * kSigma;  // the least that is taken
  Ring ring(quiet, 0.0);
  ring.values[50] += first * kScatter;
  ring.values[51] += second * kScatter;
  return ring.followed();
}

TEST(RingProcess, AValueIsDoubtedFromFourStandardDeviationsOn) {
  EXPECT_EQ(withStrays(4.5, 0.0).doubt[50], 0.0);  // three from what the others say, which are uncertain too
  EXPECT_NEAR(withStrays(9.0, 0.0).doubt[50], 6.0, 0.2);
}

/// Each is off what the others say by 0.67 times its own less 0.36 times its neighbour's.
TEST(RingProcess, ANeighbourOffTheSameWayByOneAndAHalfStandardDeviationsMakesItADip) {
  EXPECT_GT(withStrays(15.0, 9.5).doubt[50], 4.0) << "neighbour off by 1";
  EXPECT_EQ(withStrays(15.0, 11.3).doubt[50], 0.0) << "neighbour off by 2.2";
  EXPECT_GT(withStrays(15.0, -9.5).doubt[50], 4.0) << "neighbour off the other way";
}

TEST(RingProcess, WavesUpToTheFourthAreTheShapesNotTheProcesss) {
  const auto followedShare = [](double order) {
    Ring ring(quiet, 0.0);
    for (std::size_t i = 0; i < kCount; ++i)
      ring.values[i] = 0.004 * std::cos(order * static_cast<double>(i) * M_PI / 180.0);
    return followRing(ring.values, ring.sigmas, 1e-9).value[0] / 0.004;  // a process that can do nothing
  };
  EXPECT_NEAR(followedShare(4.0), 1.0, 0.01);
  EXPECT_NEAR(followedShare(5.0), 0.0, 0.01);
}

/// The likeliest variance v of values x by Student's distribution has the mean of 31 x^2 / (30 v + x^2) at 1. Here v is
/// two given variances: 0.05 * 31 * 100 / 160 + 0.95 * 31 * 0.0625 / 60.0625 = 1.0.
TEST(RingProcess, ScatterIsJudgedByStudentsDistributionOfThirtyDegreesOfFreedom) {
  Ring ring(quiet, 0.0);
  for (std::size_t i = 0; i < kCount; ++i) {
    const double off = i % 20 == 0 ? 10.0 * (i % 40 == 0 ? 1.0 : -1.0) : 0.25 * (i % 2 == 0 ? 1.0 : -1.0);
    ring.values[i] = off * kSigma;
  }
  EXPECT_NEAR(followRing(ring.values, ring.sigmas, 1e-9).nugget, kSigma, 1e-9);
}

TEST(RingProcess, NorHasARingOfTwelveUnlikeValuesThatTheProcessFollowsFarApart) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const std::vector<double> nothing(kCount, NAN);
  std::vector<double> values = nothing, turned = nothing, sigmas = nothing;
  for (std::size_t i = 0; i < kCount; i += 30) {
    values[i] = turned[(i + 180) % kCount] = 0.005 * normal(random);
    sigmas[i] = kSigma;
  }
  const RingProcess a = followRing(values, sigmas, kFlexible), b = followRing(turned, sigmas, kFlexible);
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(a.value[i], b.value[(i + 180) % kCount], 4e-5);
}

}  // namespace tank_datum::ring_process_test
