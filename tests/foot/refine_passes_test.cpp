#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/refine.h"
#include "support/made_rings.h"

namespace tank_datum::refine_passes_test {

using namespace made_rings;

constexpr double kRadius = 5.0, kNoise = 0.0005;

double wave(double azimuth) { return 0.010 * std::cos(8.0 * azimuth); }

/// A shell upon a pad that waves, of which each degree has few points.
Ring wavingRing(int shell, int pad) {
  MadeRing<wave> made(9);
  for (int i = 0; i < shell; ++i) made.add(kRadius + made.noise(kNoise), 0.5 * made.any());
  for (int i = 0; i < pad; ++i) made.add(kRadius + 0.3 * made.any(), made.noise(kNoise));
  return made.ring;
}

TEST(RefineStations, TheSectionIsAsSharpAsItsPointsThoughTheFirstLookSmoothsTheDatum) {
  const RefinedFoot found = refineStations(wavingRing(20'000, 1'400), levelTank(kRadius), {}, {});
  EXPECT_NEAR(found.refined.profile.noise, kNoise, 0.2 * kNoise);
}

constexpr double kWide = 18.6, kDipHalf = 7.0 * kDegree, kDipDepth = 0.012;

double dip(double azimuth) {
  const double share = std::abs(azimuth - 0.5 * kTwoPi) / kDipHalf;
  return share < 1.0 ? -0.5 * kDipDepth * (1.0 + std::cos(0.5 * kTwoPi * share)) : 0.0;
}

/// A shell upon a lip 55 mm wide and 10 mm thick, three points of it to a degree, that dips by more than its thickness.
Ring dippingRing() {
  constexpr double kLip = 0.055, kThickness = 0.010;
  MadeRing<dip> made(4);
  for (int i = 0; i < 120'000; ++i) made.add(kWide + made.noise(0.0015), 0.5 * made.any());
  for (int i = 0; i < 1'200; ++i) made.add(kWide + kLip * made.any(), made.noise(kNoise));
  for (int i = 0; i < 2'000; ++i) made.add(kWide + kLip + made.noise(0.0015), -kThickness * made.any());
  for (int i = 0; i < 20'000; ++i) made.add(kWide + kLip + 0.245 * made.any(), -kThickness + made.noise(kNoise));
  return made.ring;
}

TEST(RefineStations, ADipOfFewPointsIsMeasuredFromItsEdgesInwards) {
  const std::vector<StationDatum> stations = refineStations(dippingRing(), levelTank(kWide), {}, {}).stations;
  std::size_t measured = 0;
  for (const StationDatum& s : stations) {
    const double off = std::abs(s.direction - 0.5 * kTwoPi);
    if (off > kDipHalf || s.flag != StationFlag::Measured) continue;
    ++measured;
    EXPECT_LT(std::abs(s.z - dip(s.direction)), 4.0 * s.sigma_z) << s.direction / kDegree;
  }
  EXPECT_GE(measured, 9U);
}

/// The stations that are measured of a shell upon a pad that falls by so much, against which a steeper bank lies but
/// for 60 degrees.
std::vector<StationDatum> measuredBesideBank(double pad) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any;
  constexpr double kHigh = 0.12, kSlope = 0.25;
  Ring ring;
  ring.reach = 0.5;
  for (int i = 0; i < 400'000; ++i) {
    const double a = kTwoPi * any(random), d = 0.5 * any(random), beside = std::abs(a - 0.5 * kTwoPi) - 30.0 * kDegree;
    const double bank = std::min(1.0, beside / (3.0 * kDegree)) * kHigh - kSlope * d;
    const double ground = beside > 0.0 ? std::max(-pad * d, bank) : -pad * d;
    const double rough = ground > -pad * d ? 0.01 : kNoise, height = 0.5 * any(random);
    if (i % 2 == 0)
      ring.points.push_back(
          {(kRadius + d) * std::cos(a), (kRadius + d) * std::sin(a), ground + rough * normal(random)});
    const double r = kRadius + kNoise * normal(random);
    if (i % 2 == 1 && height > std::max(0.0, bank + kSlope * d))
      ring.points.push_back({r * std::cos(a), r * std::sin(a), height});
  }
  return measuredOf(refineStations(ring, levelTank(kRadius), {}, {}).stations);
}

TEST(RefineStations, ABankAgainstMostOfAShellDoesNotHideTheFootThatIsSeen) {
  const std::vector<StationDatum> measured = measuredBesideBank(0.0);
  EXPECT_GE(measured.size(), 57U);
  EXPECT_LE(measured.size(), 66U);
  for (const StationDatum& s : measured) EXPECT_NEAR(s.z, 0.0, 0.001) << s.direction;
}

TEST(RefineStations, WhatABankLeavesMustBeGentlerThanBanksEnd) {
  EXPECT_GT(measuredBesideBank(0.08).size(), 50U);
  EXPECT_EQ(measuredBesideBank(0.107).size(), 0U);
}

}  // namespace tank_datum::refine_passes_test
