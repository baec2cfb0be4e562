#include "foot/foot_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "support/level_fits.h"
#include "support/rough_surface.h"

namespace tank_datum::foot_roughness_test {

using made_feet::levelOf, made_feet::RoughSurface;

FootProfile pad() {
  FootProfile profile;
  profile.band_from = 0.0, profile.band_to = 0.3;
  return profile;
}

/// Fits of 120 points each, all of a part of the band raised or lowered together, with noise of their own.
std::vector<FittedPoints> fitsOf(int parts, double rough, double noise, int fits = 400) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<FittedPoints> all;
  for (int k = 0; k < fits; ++k) {
    FittedPoints fitted;
    std::vector<double> patches;
    for (int p = 0; p < parts; ++p) patches.push_back(rough * normal(random));
    double mean = 0;
    for (int i = 0; i < 120; ++i) {
      const double d = 0.3 * (i + 0.5) / 120;
      fitted.points.push_back({0.0, d, patches[static_cast<std::size_t>(d / 0.3 * parts)] + noise * normal(random)});
      mean += fitted.points.back().z / 120;
    }
    fitted.fit.z = mean, fitted.fit.slope = 0, fitted.fit.along = 0, fitted.fit.bend = 0;
    fitted.fit.noise = std::hypot(noise, rough), fitted.fit.sigma = fitted.fit.noise / std::sqrt(120.0);
    fitted.fit.points = 120;
    all.push_back(fitted);
  }
  return all;
}

TEST(SharedRoughness, OfPointsThatErrAloneIsNone) {
  EXPECT_LT(std::sqrt(sharedRoughness(fitsOf(3, 0.0, 0.001), pad())), 3e-5);
}

TEST(SharedRoughness, IsTheVarianceOfPatchesOverTheirNumber) {
  for (const int parts : {3, 6}) {
    const double level = std::sqrt(sharedRoughness(fitsOf(parts, 0.0005, 0.001), pad()));
    EXPECT_NEAR(level, 0.0005 / std::sqrt(parts), 0.12 * 0.0005 / std::sqrt(parts)) << parts;
  }
}

TEST(SharedRoughness, IsToldByFitsWithTenPointsAPart) {
  std::vector<FittedPoints> fits = fitsOf(3, 0.0005, 0.001);
  for (FittedPoints& f : fits) f.fit.points = 29;
  EXPECT_EQ(sharedRoughness(fits, pad()), 0.0);
  for (FittedPoints& f : fits) f.fit.points = 31;
  EXPECT_GT(sharedRoughness(fits, pad()), 0.0);
}

/// Windows of 1 m along a rough pad, each with points here and there, fitted.
std::vector<FittedPoints> windowsOf(const RoughSurface& rough, int count, double noise, int windows = 72) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> along(-0.5, 0.5), across(0.0, 0.3);
  FootProfile profile = pad();
  profile.edge = 0.3, profile.blur = 0.0, profile.noise = 0.001;
  FootPrior prior;
  prior.sigma_slope = 1.0, prior.sigma_bend = 1.0;
  std::vector<FittedPoints> all;
  for (int k = 0; k < windows; ++k) {
    std::vector<FootPoint> points;
    for (int i = 0; i < count; ++i) {
      const double t = along(random), d = across(random);
      points.push_back({t, d, rough(2.0 * k + t, d) + noise * normal(random)});
    }
    const FootFit fit = fitFoundation(points, profile, 0.0, prior);
    all.push_back({points, fit});
  }
  return all;
}

TEST(RoughnessOf, IsThatOfTheSurface) {
  for (const double length : {0.008, 0.015, 0.03}) {
    const Roughness rough = roughnessOf(windowsOf(RoughSurface(0.0015, length), 600, 0.0), pad(), 0.0);
    EXPECT_NEAR(rough.heights, 0.0015, 0.00008) << length;
    EXPECT_NEAR(rough.length, length, 0.1 * length);
    EXPECT_NEAR(rough.slopes(), rough.heights / rough.length, 1e-12);
  }
}

TEST(RoughnessOf, NoiseOfEachPointAloneIsNone) {
  const auto noisy = windowsOf(RoughSurface(0.0015, 0.015), 600, 0.001);
  EXPECT_NEAR(roughnessOf(noisy, pad(), 0.001).heights, 0.0015, 0.00006);
  EXPECT_NEAR(roughnessOf(noisy, pad(), 0.001).length, 0.015, 0.002);
  EXPECT_EQ(roughnessOf(noisy, pad(), 0.003).slopes(), 0.0);
}

TEST(RoughnessOf, PointsBesideTheBandOrFarOffAreNotOfTheSurface) {
  auto windows = windowsOf(RoughSurface(0.0015, 0.015), 600, 0.0);
  const Roughness before = roughnessOf(windows, pad(), 0.0);
  for (FittedPoints& w : windows) {
    for (int i = 0; i < 30; ++i) {
      w.points.push_back({0.01 * i, 0.15, w.fit.z + w.fit.slope * 0.15 + 5.0 * w.fit.noise});
      w.points.push_back({0.01 * i, 0.31, w.fit.z});
    }
  }
  EXPECT_EQ(roughnessOf(windows, pad(), 0.0).heights, before.heights);
  EXPECT_EQ(roughnessOf(windows, pad(), 0.0).length, before.length);
}

TEST(RoughnessOf, WhatAFitTakesAwayIsGivenBack) {
  const Roughness rough = roughnessOf(windowsOf(RoughSurface(0.0015, 0.008), 12, 0.0, 4000), pad(), 0.0);
  EXPECT_NEAR(rough.heights, 0.0015, 0.0001);
}

TEST(RoughnessOf, PatchesMayBeAsShortAsFewPairsLeaveOpen) {
  const RoughSurface surface(0.0015, 0.012);
  const double many = roughnessOf(windowsOf(surface, 600, 0.0), pad(), 0.0).length;
  const double few = roughnessOf(windowsOf(surface, 60, 0.0), pad(), 0.0).length;
  EXPECT_NEAR(many, 0.012, 0.0012);
  EXPECT_NEAR(few, 0.0085, 0.0012);
}

/// Windows of a few rows of a scan each, points 36 mm apart, whose rays meet bumps farther out.
std::vector<FittedPoints> rowsOf(const RoughSurface& rough, const std::vector<double>& rows, double steepness,
                                 double known) {
  std::vector<FittedPoints> all;
  for (int k = 0; k < 72; ++k) {
    std::vector<FootPoint> points;
    for (const double d : rows) {
      for (double t = -0.5; t < 0.5; t += 0.036) {
        const double z = rough(2.0 * k + t, d);
        points.push_back({t, d + 0.001 * (k % 30) + z / steepness, z});
      }
    }
    all.push_back(levelOf(std::move(points), 0.0013, known));
  }
  return all;
}

const std::vector<double> kRows{0.03, 0.1, 0.17, 0.24};

TEST(RoughnessOf, PairsOfOneRowAreChosenWhereItsRaysWouldMeetTheSurface) {
  const RoughSurface surface(0.0013, 0.0045);
  // patches are of the length that a standard error leaves open, or as short as 5 mm
  EXPECT_NEAR(roughnessOf(rowsOf(surface, kRows, 0.1, 0.1), pad(), 0.0).length, 0.0085, 0.0012);
  EXPECT_NEAR(roughnessOf(rowsOf(RoughSurface(0.0013, 0.025), kRows, 0.1, 0.1), pad(), 0.0).length, 0.025, 0.005);
  EXPECT_LT(roughnessOf(rowsOf(surface, {0.15}, 0.03, 0.03), pad(), 0.0).length, 0.02);
  EXPECT_GT(roughnessOf(rowsOf(surface, {0.15}, 0.03, 1e9), pad(), 0.0).length, 0.025) << "as alike as d makes them";
}

TEST(RoughnessOf, WhereRaysAreNotKnownNothingIsSeen) {
  EXPECT_EQ(roughnessOf(rowsOf(RoughSurface(0.0013, 0.0045), kRows, 0.1, 0.0), pad(), 0.0).heights, 0.0);
}

TEST(RoughnessOf, FiftyPointsOfACellTell) {
  std::vector<FootPoint> points;
  for (int i = 0; i < 100; ++i)
    points.push_back({4.8e-4 * (i - 50), 0.001 + 4.8e-4 * (i * 37 % 100), i % 4 == 2 ? -0.001 : 0.001});
  const std::vector<FittedPoints> one{levelOf(points, 0.001, 1e9)};
  EXPECT_NEAR(roughnessOf(one, pad(), 0.0).length, 0.005, 1e-6) << "every other one: as many above as below";
}

TEST(RoughnessOf, NothingSeenIsNoRoughness) {
  EXPECT_EQ(roughnessOf({}, pad(), 0.0).slopes(), 0.0);
  EXPECT_EQ(roughnessOf({FittedPoints{}}, pad(), 0.0).slopes(), 0.0);
}

}  // namespace tank_datum::foot_roughness_test
