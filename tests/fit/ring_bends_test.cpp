#include "fit/ring_bends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::ring_bends_test {

constexpr std::size_t kCount = 360;
constexpr double kSigma = 0.001;

/// A level ring but for a dip about 120 degrees, eight degrees from rim to rim; a value every second degree.
RingData dipped(double depth) {
  RingData data{std::vector<double>(kCount, std::nan("")), std::vector<double>(kCount, kSigma * kSigma),
                kTwoPi / kCount};
  for (std::size_t i = 0; i < kCount; i += 2) {
    const double off = std::abs(static_cast<double>(i) - 120.0);
    data.values[i] = off < 4.0 ? -depth * (1.0 + std::cos(kPi * off / 4.0)) / 2.0 : 0.0;
  }
  return data;
}

const ProcessParameters kStiff{0.005, toRadians(18.0), 1.0, 0.0}, kQuick{0.02, toRadians(5.0), 1.0, 0.0};

RingProcess smoothed(const RingData& data, const ProcessParameters& p) {
  RingProcess ring;
  ring.value.resize(kCount), ring.sigma.resize(kCount);
  smoothRing(data, p, ring);
  return ring;
}

RingProcess bent(const RingData& data, const std::vector<ProcessParameters>& alternatives = {kQuick}) {
  RingProcess ring = smoothed(data, kStiff);
  followBends(data, kStiff, alternatives, ring);
  return ring;
}

TEST(RingBends, ADipThatTheRingsProcessSmoothsIsFollowed) {
  constexpr double kDepth = 0.016;
  const RingData data = dipped(kDepth);
  const RingProcess ring = bent(data);
  EXPECT_GT(smoothed(data, kStiff).value[120] + kDepth, 5.0 * kSigma);
  EXPECT_NEAR(ring.value[120], -kDepth, kSigma);
  EXPECT_LT(ring.sigma[120], 1.2 * kSigma);
}

TEST(RingBends, FarFromOneTheRingsProcessStands) {
  const RingData data = dipped(0.016);
  const RingProcess ring = bent(data), stiff = smoothed(data, kStiff);
  EXPECT_NEAR(ring.value[300], stiff.value[300], 0.02 * kSigma);
  EXPECT_NEAR(ring.sigma[300], stiff.sigma[300], 0.02 * kSigma);
}

/// By how much the quick process counts in the middle of a dip: 0 to 1.
double shareAt(double depth) {
  const RingData data = dipped(depth);
  const double stiff = smoothed(data, kStiff).value[120], quick = smoothed(data, kQuick).value[120];
  return (bent(data).value[120] - stiff) / (quick - stiff);
}

TEST(RingBends, OneInFourHundredIsTakenForABend) {
  EXPECT_LT(shareAt(0.0070), 0.2);
  EXPECT_GT(shareAt(0.0085), 0.8);
}

TEST(RingBends, SigmaHoldsWhatTheProcessesDifferByWhereEitherMayBe) {
  double largest = 0.0;
  for (double depth = 0.004; depth < 0.010; depth += 0.0002)
    largest = std::max(largest, bent(dipped(depth)).sigma[120]);
  EXPECT_GT(largest, 1.5 * bent(dipped(0.016)).sigma[120]);
}

TEST(RingBends, ValuesWithinFiveDegreesTell) {
  RingData data = dipped(0.0);
  for (const std::size_t i : {118U, 120U, 122U}) data.values[i] = i == 120 ? -0.020 : 0.020;
  const RingProcess ring = bent(data), stiff = smoothed(data, kStiff);
  EXPECT_GT(std::abs(ring.value[126] - stiff.value[126]), 0.5 * kSigma);
  EXPECT_LT(std::abs(ring.value[129] - stiff.value[129]), 0.1 * kSigma);
}

TEST(RingBends, ThereAreNoneWhereNothingIsKnown) {
  RingData data = dipped(0.016);
  for (std::size_t i = 200; i < 240; ++i) data.values[i] = std::nan("");
  EXPECT_EQ(bent(data).sigma[220], smoothed(data, kStiff).sigma[220]);
}

}  // namespace tank_datum::ring_bends_test
