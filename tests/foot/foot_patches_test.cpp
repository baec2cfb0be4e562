#include "foot/foot_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/rough_surface.h"

namespace tank_datum {
namespace {

using made_feet::RoughSurface;

constexpr double kArc = 0.08, kRough = 0.001;

FootProfile pad() {
  FootProfile profile;
  profile.band_from = 0.0, profile.band_to = profile.edge = 0.3;
  profile.blur = 0.0, profile.noise = kRough;
  return profile;
}

/// Fits of stations far apart on a pad whose level changes from one to the next.
std::vector<FittedPoints> stationsOn(const RoughSurface& rough, double noise, int points = 120, int stations = 400) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> along(-0.5 * kArc, 0.5 * kArc), across(0.0, 0.3);
  std::vector<FittedPoints> all;
  for (int k = 0; k < stations; ++k) {
    FittedPoints fitted;
    double mean = 0;
    for (int i = 0; i < points; ++i) {
      const double t = along(random), d = across(random);
      fitted.points.push_back({t, d, 0.003 * (k % 3) + rough(2.0 * k + t, d) + noise * normal(random)});
      mean += fitted.points.back().z / points;
    }
    FootFit& fit = fitted.fit;
    fit.z = mean, fit.slope = fit.along = fit.bend = 0.0;
    fit.noise = std::hypot(noise, kRough), fit.sigma = fit.noise / std::sqrt(points);
    fit.points = static_cast<std::size_t>(points);
    all.push_back(std::move(fitted));
  }
  return all;
}

TEST(PatchesOf, AreThoseOfTheSurfaceWhateverItsLevelsAndTheNoiseAre) {
  for (const double length : {0.016, 0.025, 0.05, 0.07}) {
    for (const double noise : {0.0, 0.001}) {
      const Roughness found = patchesOf(stationsOn(RoughSurface(kRough, length), noise), pad(), kArc);
      EXPECT_NEAR(found.length, length, 0.15 * length) << noise;
      EXPECT_NEAR(found.heights, kRough, 0.12 * kRough) << length;
    }
  }
}

TEST(PatchesOf, ShorterThanAPartOrLongerThanAThirdOfTheBandAreNotTold) {
  EXPECT_GE(patchesOf(stationsOn(RoughSurface(kRough, 0.004), 0.0), pad(), kArc).length, 0.0099);
  EXPECT_LE(patchesOf(stationsOn(RoughSurface(kRough, 0.2), 0.0), pad(), kArc).length, 0.1);
}

TEST(PatchesOf, AreToldByStationsOfFortyPoints) {
  const RoughSurface surface(kRough, 0.05);
  EXPECT_EQ(patchesOf(stationsOn(surface, 0.0, 39), pad(), kArc).heights, 0.0);
  EXPECT_GT(patchesOf(stationsOn(surface, 0.0, 40), pad(), kArc).heights, 0.0);
  EXPECT_EQ(patchesOf({}, pad(), kArc).heights, 0.0);
}

/// Variance of the mean of a rough surface over a band and an arc.
double varianceOver(const RoughSurface& rough, double arc) {
  constexpr int kPlaces = 300, kPoints = 6;
  double squares = 0;
  for (int k = 0; k < kPlaces; ++k) {
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
      for (int j = 0; j < 2 * kPoints; ++j)
        sum += rough(3.0 * k + arc * (i + 0.5) / kPoints, 0.3 * (j + 0.5) / (2 * kPoints));
    }
    squares += std::pow(sum / (2 * kPoints * kPoints), 2.0) / kPlaces;
  }
  return squares;
}

TEST(LevelRoughness, IsTheVarianceOfAMeanOverTheBandAndAnArc) {
  const LevelRoughness level = levelRoughness({kRough, 0.04}, pad(), kArc, 0.0);
  const RoughSurface surface(kRough, 0.04, 600);
  EXPECT_NEAR(level.variance, varianceOver(surface, kArc), 0.12 * level.variance);
  EXPECT_NEAR(level.over(0.4), varianceOver(surface, 0.4), 0.15 * level.over(0.4));
  EXPECT_NEAR(level.over(0.01), level.variance, 1e-12);
}

TEST(LevelRoughness, IsNoLessThanIsKnownAndOfUnknownPatchesThatAlone) {
  EXPECT_EQ(levelRoughness({kRough, 0.04}, pad(), kArc, 1.0).variance, 1.0);
  const LevelRoughness unknown = levelRoughness({}, pad(), kArc, 1e-6);
  EXPECT_EQ(unknown.variance, 1e-6);
  EXPECT_EQ(unknown.over(0.4), 0.0);
  EXPECT_EQ(unknown.leftOutBy({}, 0, 0.001), 0.0);
}

TEST(LevelRoughness, AProcessLeavesOutWhatStationsThatItAveragesShare) {
  const LevelRoughness level = levelRoughness({kRough, 0.04}, pad(), kArc, 0.0);
  RingProcess process;
  process.sigma = {0.0005};
  // four levels of 1 mm, which patches of half their variance do not make a quarter of it
  EXPECT_NEAR(level.leftOutBy(process, 0, 0.001), level.over(4.0 * kArc) - 0.25 * level.variance, 1e-12);
  EXPECT_GT(level.leftOutBy(process, 0, 0.001), 0.0);
  process.scale = 0.5;  // values that patches make alike seem to scatter by half
  EXPECT_NEAR(level.leftOutBy(process, 0, 0.001), 0.75 * level.variance, 1e-12);
  process.nugget = 0.0005 * std::sqrt(3.0);  // which a nugget adds to
  EXPECT_NEAR(level.leftOutBy(process, 0, 0.001), level.over(4.0 * kArc) - 0.0625 * level.variance, 1e-12);
}

}  // namespace
}  // namespace tank_datum
