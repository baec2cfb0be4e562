#include "foot/foot_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum {
namespace {

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

}  // namespace
}  // namespace tank_datum
