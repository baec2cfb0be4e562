#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/refine.h"

namespace tank_datum {
namespace {

constexpr double kRadius = 5.0, kNoise = 0.0005;

double wave(double azimuth) { return 0.010 * std::cos(8.0 * azimuth); }

/// A shell upon a pad that waves, of which each degree has few points.
Ring wavingRing(int shell, int pad) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any;
  Ring ring;
  ring.reach = 0.5;
  const auto add = [&](double r, double height) {
    const double a = kTwoPi * any(random);
    ring.points.push_back({r * std::cos(a), r * std::sin(a), wave(a) + height});
  };
  for (int i = 0; i < shell; ++i) add(kRadius + kNoise * normal(random), 0.5 * any(random));
  for (int i = 0; i < pad; ++i) add(kRadius + 0.3 * any(random), kNoise * normal(random));
  return ring;
}

TEST(RefineStations, TheSectionIsAsSharpAsItsPointsThoughTheFirstLookSmoothsTheDatum) {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  const RefinedFoot found = refineStations(wavingRing(20'000, 1'400), tank, {}, {});
  EXPECT_NEAR(found.refined.profile.noise, kNoise, 0.2 * kNoise);
}

constexpr double kDipHalf = 7.0 * kDegree, kDipDepth = 0.012;

double dip(double azimuth) {
  const double share = std::abs(azimuth - 0.5 * kTwoPi) / kDipHalf;
  return share < 1.0 ? -0.5 * kDipDepth * (1.0 + std::cos(0.5 * kTwoPi * share)) : 0.0;
}

/// A shell upon a lip 55 mm wide and 10 mm thick, three points of it to a degree, that dips by more than its thickness.
Ring dippingRing() {
  constexpr double kWide = 18.6, kLip = 0.055, kThickness = 0.010;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any;
  Ring ring;
  ring.reach = 0.5;
  const auto add = [&](double d, double height) {
    const double a = kTwoPi * any(random), r = kWide + d;
    ring.points.push_back({r * std::cos(a), r * std::sin(a), dip(a) + height});
  };
  for (int i = 0; i < 120'000; ++i) add(0.0015 * normal(random), 0.5 * any(random));
  for (int i = 0; i < 1'200; ++i) add(kLip * any(random), kNoise * normal(random));
  for (int i = 0; i < 2'000; ++i) add(kLip + 0.0015 * normal(random), -kThickness * any(random));
  for (int i = 0; i < 20'000; ++i) add(kLip + 0.245 * any(random), -kThickness + kNoise * normal(random));
  return ring;
}

TEST(RefineStations, ADipOfFewPointsIsMeasuredFromItsEdgesInwards) {
  Tank tank;
  tank.circle = {{0.0, 0.0}, 18.6};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  const std::vector<StationDatum> stations = refineStations(dippingRing(), tank, {}, {}).stations;
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
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  std::vector<StationDatum> measured = refineStations(ring, tank, {}, {}).stations;
  measured.erase(std::remove_if(measured.begin(), measured.end(),
                                [](const StationDatum& s) { return s.flag != StationFlag::Measured; }),
                 measured.end());
  return measured;
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

}  // namespace
}  // namespace tank_datum
