#include "foot/foot_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/made_feet.h"
#include "support/rough_surface.h"

namespace tank_datum::foot_patches_test {

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
      const Roughness found = patchesOf(stationsOn(RoughSurface(kRough, length), noise), pad());
      EXPECT_NEAR(found.length, length, 0.15 * length) << noise;
      EXPECT_NEAR(found.heights, kRough, 0.12 * kRough) << length;
    }
  }
}

TEST(PatchesOf, ShorterThanAPartOrLongerThanAThirdOfTheBandAreNotTold) {
  EXPECT_GE(patchesOf(stationsOn(RoughSurface(kRough, 0.004), 0.0), pad()).length, 0.0099);
  EXPECT_LE(patchesOf(stationsOn(RoughSurface(kRough, 0.2), 0.0), pad()).length, 0.1);
}

TEST(PatchesOf, AreToldByWindowsOfTenPoints) {
  const RoughSurface surface(kRough, 0.05);
  EXPECT_EQ(patchesOf(stationsOn(surface, 0.0, 9), pad()).heights, 0.0);
  EXPECT_NEAR(patchesOf(stationsOn(surface, 0.0, 10), pad()).heights, kRough, 0.2 * kRough);
  EXPECT_EQ(patchesOf({}, pad()).heights, 0.0);
}

TEST(PatchesOf, LongerThanALipIsWideAreToldAlongIt) {
  FootProfile lip = pad();
  lip.band_to = lip.edge = 0.04;
  const RoughSurface surface(kRough, 0.05);
  std::vector<FittedPoints> windows;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> along(-0.2, 0.2), across(0.0, 0.04);
  FootPrior prior;
  prior.sigma_slope = prior.sigma_bend = 1.0;
  for (int k = 0; k < 400; ++k) {
    std::vector<FootPoint> points;
    for (int i = 0; i < 30; ++i) {
      const double t = along(random), d = across(random);
      points.push_back({t, d, surface(k + t, d) + 0.001 * normal(random)});
    }
    const FootFit fit = fitFoundation(points, lip, 0.0, prior);
    windows.push_back({std::move(points), fit});
  }
  const Roughness found = patchesOf(windows, lip);
  EXPECT_NEAR(found.heights, kRough, 0.15 * kRough);
  EXPECT_NEAR(found.length, 0.05, 0.2 * 0.05);
}

TEST(PatchesOf, NoMoreThanAHundredAndTwentyPointsOfAWindowAreLookedAtEvenly) {
  const auto some = stationsOn(RoughSurface(kRough, 0.05), 0.0, 120, 20);
  auto more = some, fewer = some;
  for (std::size_t k = 0; k < some.size(); ++k) {
    more[k].points.clear(), fewer[k].points.clear();
    for (std::size_t i = 0; i < some[k].points.size(); ++i) {
      more[k].points.insert(more[k].points.end(), {some[k].points[i], {0.0, 0.1, some[k].fit.z}});
      if (i % 2 == 0) fewer[k].points.push_back(some[k].points[i]);
    }
  }
  EXPECT_EQ(patchesOf(more, pad()).heights, patchesOf(some, pad()).heights);
  EXPECT_NE(patchesOf(fewer, pad()).heights, patchesOf(some, pad()).heights);
}

TEST(PatchesOf, NoisyWindowsTellLess) {
  auto windows = stationsOn(RoughSurface(kRough, 0.03), 0.0);
  const double before = patchesOf(windows, pad()).heights;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (std::size_t k = 0; k < windows.size(); k += 20) {
    double level = 0.0;
    for (std::size_t i = 0; i < windows[k].points.size(); ++i) {
      if (i % 12 == 0) level = 10.0 * kRough * normal(random);
      windows[k].points[i].z += level;
    }
    windows[k].fit.noise *= 10.0;
  }
  EXPECT_NEAR(patchesOf(windows, pad()).heights, before, 0.1 * before);
}

TEST(PatchesOf, OfPointsThatErrAloneAreHardlyAny) {
  auto windows = stationsOn(RoughSurface(0.0, 0.05), 0.001);
  EXPECT_LT(patchesOf(windows, pad()).heights, 0.0001);
}

TEST(PatchWindows, AreFortyCentimetresLongAndFiveDegreesAtMost) {
  made_feet::MadeFoot made;
  made.addAll(12, 0.02, 0.28, [](double) { return 0.0; });
  Foot& foot = made.foot();
  FootPass pass;
  pass.sections.whole = pad();
  pass.sections.stations = 360;
  pass.priors.slope.assign(360, 0.0);
  pass.priors.sigma_slope.assign(360, 0.003);
  pass.priors.sigma_bend = 0.003;
  FootFit fit;
  fit.z = 0.0, fit.sigma = 0.001;
  pass.fits.assign(360, fit);
  const auto windows = patchWindows(foot, pass);  // of two stations 0.17 m long
  ASSERT_EQ(windows.size(), 180U);
  EXPECT_EQ(windows[20].points.size(), 24U);
  EXPECT_TRUE(windows[20].fit.valid());
  foot.radius = 2.0;
  ASSERT_EQ(patchWindows(foot, pass).size(), 72U);
  pass.fits[2] = {};
  EXPECT_FALSE(patchWindows(foot, pass)[0].fit.valid());
  foot.radius = 100.0;
  EXPECT_EQ(patchWindows(foot, pass).size(), 360U);
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

TEST(LevelRoughness, SlopesDifferByMoreThanPatchesMakeThem) {
  const LevelRoughness level = levelRoughness({kRough, 0.04}, pad(), kArc, 0.0);
  const double band = pad().band_to - pad().band_from;
  const double patches = kRough / band * std::sqrt(12.0 * sharedAlong(0.4, 0.04));
  EXPECT_NEAR(level.slopesBeyond(2.0 * patches, pad(), 0.4), std::sqrt(3.0) * patches, 1e-6);
  EXPECT_EQ(level.slopesBeyond(0.9 * patches, pad(), 0.4), 0.0);
  EXPECT_EQ(levelRoughness({}, pad(), kArc, 1e-6).slopesBeyond(0.01, pad(), 0.4), 0.01);
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

}  // namespace tank_datum::foot_patches_test
