#include "foot/slanting_beams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "foot/foot_profile.h"

namespace tank_datum::slanting_beams_test {

FootProfile lip() {
  FootProfile profile;
  profile.band_from = 0.015;
  profile.band_to = 0.055;
  profile.noise = 0.001;
  profile.blur = 0.004;
  return profile;
}

/// A window of `on_lip` points on a lip 40 mm wide and `on_shell` points on 200 mm of shell; reach 0.5 m.
std::vector<FootPoint> window(int on_lip, int on_shell) {
  std::vector<FootPoint> points;
  for (int i = 0; i < on_lip; ++i) {
    FootPoint p{};
    p.d = 0.016 + 0.038 * i / on_lip, p.z = 2.0;
    points.push_back(p);
  }
  for (int i = 0; i < on_shell; ++i) {
    FootPoint p{};
    p.d = 0.0, p.z = 2.051 + 0.198 * i / on_shell;
    points.push_back(p);
  }
  return points;
}

TEST(SteepnessOf, IsTheRatioOfTheDensitiesOnFoundationAndShell) {
  // at 45 degrees both are met alike: 40 points on 40 mm, 200 on 200 mm
  EXPECT_NEAR(steepnessOf(window(40, 200), lip(), 2.0, 0.5), 1.0, 1e-12);
  EXPECT_NEAR(steepnessOf(window(10, 500), lip(), 2.0, 0.5), 0.1, 1e-12);
}

TEST(SteepnessOf, PointsOffBothSurfacesDoNotCount) {
  std::vector<FootPoint> points = window(40, 200);
  for (const auto& [d, z] : {std::pair{0.03, 2.1}, {0.1, 2.0}, {0.01, 2.0}, {0.0, 2.3}, {0.0, 2.02}, {0.01, 2.1}}) {
    FootPoint p{};
    p.d = d, p.z = z;
    points.push_back(p);
  }
  EXPECT_NEAR(steepnessOf(points, lip(), 2.0, 0.5), 1.0, 1e-12);
}

TEST(SteepnessOf, OfAShellThatIsHardlySeenIsNotKnown) {
  EXPECT_EQ(steepnessOf(window(40, 19), lip(), 2.0, 0.5), 0.0);
  EXPECT_GT(steepnessOf(window(40, 20), lip(), 2.0, 0.5), 0.0);
}

/// Steepness at the first of four windows whose shells are seen alike; the others have no point of the lip.
double steepnessBesideNone(double points) {
  const std::vector<RayCounts> windows = {{points, points / 0.04, 200}, {0, 0, 200}, {0, 0, 200}, {0, 0, 200}};
  return steepnessAlong(windows, pooledSteepness(windows, 0.5), 0.5).front();
}

TEST(SteepnessAlong, OfFewPointsIsThatOfTheWindowsBesideTogether) {
  EXPECT_NEAR(steepnessBesideNone(50), 50.0 / 0.04 / (200.0 / 0.2), 1e-12);
  EXPECT_NEAR(steepnessBesideNone(49), 49.0 / 0.04 / (600.0 / 0.2), 1e-12);
  const std::vector<RayCounts> few = {{4, 100, 200}, {40, 1000, 200}, {9, 200, 200}};
  EXPECT_NEAR(steepnessAlong(few, pooledSteepness(few, 0.5), 0.5)[0], 0.1, 1e-12) << "seen so";
}

/// What a level surface between two distances shows whose points range noise moves along rays of some steepness.
std::vector<FootPoint> movedAlongRays(double from, double to, double steepness, double noise) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<FootPoint> points;
  for (int i = 0; i < 400000; ++i) {
    const double along = noise * normal(random);
    FootPoint p{};
    p.d = from + (to - from) * (i + 0.5) / 400000.0 + along, p.z = steepness * along;
    points.push_back(p);
  }
  return points;
}

/// The slope of the points in the lip's band, by least squares.
double slopeInBand(const std::vector<FootPoint>& points) {
  double count = 0, d = 0, z = 0, dd = 0, dz = 0;
  for (const FootPoint& p : points) {
    if (p.d < lip().band_from || p.d > lip().band_to) continue;
    count += 1, d += p.d, z += p.z, dd += p.d * p.d, dz += p.d * p.z;
  }
  return (dz - d * z / count) / (dd - d * d / count);
}

constexpr double kRange = 0.002, kSteep = 0.3;

TEST(FeignedSlope, IsWhatRangeNoiseDoesWherePointsEndWithinTheBand) {
  const auto points = movedAlongRays(0.02, 0.05, kSteep, kRange);
  const double seen = slopeInBand(points);
  EXPECT_GT(seen, 0.005);
  const double feigned = feignedSlope(bandPointsOf(points, lip(), 0.0), kSteep, kRange, 1.0);
  EXPECT_NEAR(feigned, seen, 0.1 * seen);
}

TEST(FeignedSlope, IsNoneWherePointsGoOnBeyondTheBandsEnds) {
  const auto points = movedAlongRays(-0.02, 0.09, kSteep, kRange);
  EXPECT_NEAR(slopeInBand(points), 0.0, 1e-3);
  EXPECT_NEAR(feignedSlope(bandPointsOf(points, lip(), 0.0), kSteep, kRange, 1.0), 0.0, 1e-3);
}

TEST(FeignedSlope, OfFewPointsIsAsUncertainAsTheirCounts) {
  auto points = movedAlongRays(-0.02, 0.09, kSteep, kRange);
  std::vector<FootPoint> few;
  for (std::size_t i = 0; i < points.size(); i += 10000) few.push_back(points[i]);
  const BandPoints band = bandPointsOf(few, lip(), 0.0);
  EXPECT_GT(band.variance, 15.0);  // as many as lie in the band
  EXPECT_GT(feignedSlope(band, kSteep, kRange, 1.0),
            0.9 * kRange * kRange * kSteep * std::sqrt(band.variance) / band.squares);
}

TEST(FeignedSlope, MovesHeightsByNoMoreThanTheyScatter) {
  const BandPoints band = bandPointsOf(movedAlongRays(0.02, 0.05, kSteep, kRange), lip(), 0.0);
  const double quiet = 0.1 * kSteep * kRange;
  EXPECT_NEAR(feignedSlope(band, kSteep, kRange, quiet), 0.1 * feignedSlope(band, kSteep, kRange, 1.0), 1e-9);
  EXPECT_EQ(feignedSlope({}, kSteep, kRange, 1.0), 0.0);
}

/// Whether a surface that rises so is a line of blends: beams at one in five, and a crown that begins at the lip's
/// edge.
bool isGrazedBy(double slope, double crown, double sigma_slope = 0.001) {
  const double reach = 0.5;
  std::vector<FootPoint> points;
  const auto add = [&](double d, double z) {
    FootPoint p{};
    p.d = d, p.z = z;
    points.push_back(p);
  };
  for (int i = 0; i < 200; ++i) add(0.0, 0.051 + 0.198 * i / 200);  // one a millimetre
  for (int i = 0; i < 88; ++i) add(0.06 + 0.005 * i, crown);        // one in five
  FootProfile profile = lip();
  profile.edge = 0.055;
  FootFit fit;
  fit.z = 0.0, fit.slope = slope, fit.sigma_slope = sigma_slope;
  return isGrazed(points, profile, fit, reach);
}

TEST(IsGrazed, WhatRisesByAQuarterOfTheBeamsSlopeTowardsSomethingHigherIsNoSurface) {
  EXPECT_TRUE(isGrazedBy(0.055, 0.008));
  EXPECT_FALSE(isGrazedBy(0.045, 0.008));        // a lip that rises
  EXPECT_FALSE(isGrazedBy(0.055, 0.002));        // the crown is seen over at less than a quarter of it
  EXPECT_FALSE(isGrazedBy(0.055, -0.010));       // a lip upon a ringwall
  EXPECT_FALSE(isGrazedBy(0.055, 0.008, 0.02));  // may be level
}

}  // namespace tank_datum::slanting_beams_test
