#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foot/foot_check.h"
#include "foot/foot_profile.h"

namespace tank_datum::same_surface_test {

constexpr double kNoise = 0.0005;

/// The section of a plate of 65 mm on a ringwall 10 mm lower.
FootProfile plateProfile() {
  FootProfile profile;
  profile.bin = 0.003;
  for (int i = 0; i < 100; ++i) profile.height.push_back(0.003 * (i + 0.5) < 0.065 ? 0.0 : -0.010);
  profile.spread.assign(100, kNoise);
  profile.error.assign(100, 0.1 * kNoise);
  profile.spread[21] = 0.005;  // the plate's edge
  profile.band_from = 0.015, profile.band_to = 0.06, profile.edge = 0.066;
  profile.blur = 0.006;
  profile.noise = kNoise;
  profile.surface = Surface::AnnularPlate;
  return profile;
}

FootFit fitOf(double z, double sigma = 0.0002) {
  FootFit fit;
  fit.z = z, fit.sigma = sigma;
  fit.slope = 0.0, fit.sigma_slope = 0.001;
  fit.noise = kNoise;
  fit.points = 100;
  return fit;
}

/// A station's points: on a plate at z = 2, and beyond it on a ringwall this much lower.
std::vector<FootPoint> stationWith(double drop) {
  std::vector<FootPoint> points;
  for (double d = 0.001; d < 0.299; d += 0.002) points.push_back({0.0, d, d < 0.065 ? 2.0 : 2.0 - drop});
  return points;
}

TEST(IsSameSurface, OfTheSameSectionIsTrue) {
  EXPECT_TRUE(isSameSurface(stationWith(0.010), fitOf(2.0), 0.0, plateProfile()));
}

TEST(IsSameSurface, AnotherSlopeIsAnotherSurface) {
  FootFit fit = fitOf(2.0);
  for (const double sign : {-1.0, 1.0}) {
    fit.slope = sign * 0.025;
    EXPECT_TRUE(isSameSurface(stationWith(0.010), fit, 0.0, plateProfile()));
    fit.slope = sign * 0.040;
    EXPECT_FALSE(isSameSurface(stationWith(0.010), fit, 0.0, plateProfile()));
    EXPECT_TRUE(isSameSurface(stationWith(0.010), fit, fit.slope, plateProfile()));
    fit.sigma_slope = 0.010;  // cannot tell
    EXPECT_TRUE(isSameSurface(stationWith(0.010), fit, 0.0, plateProfile()));
    fit.sigma_slope = 0.001;
  }
}

TEST(IsSameSurface, ARougherOneIsAnotherSurface) {
  FootFit fit = fitOf(2.0);
  fit.noise = 2.9 * kNoise;
  EXPECT_TRUE(isSameSurface(stationWith(0.010), fit, 0.0, plateProfile()));
  fit.noise = 3.1 * kNoise;
  EXPECT_FALSE(isSameSurface(stationWith(0.010), fit, 0.0, plateProfile()));
}

TEST(IsSameSurface, TheSectionBeyondGoesOnAsElsewhere) {
  EXPECT_TRUE(isSameSurface(stationWith(0.015), fitOf(2.0), 0.0, plateProfile()));
  EXPECT_FALSE(isSameSurface(stationWith(0.025), fitOf(2.0), 0.0, plateProfile()));   // lies on 15 mm of soil
  EXPECT_FALSE(isSameSurface(stationWith(-0.005), fitOf(2.0), 0.0, plateProfile()));  // soil on the ringwall
  EXPECT_TRUE(isSameSurface(stationWith(0.025), fitOf(2.0, 0.003), 0.0, plateProfile()));
}

TEST(IsSameSurface, EndsBySteppingDownByHalfOfWhatItDoesElsewhere) {
  EXPECT_TRUE(isSameSurface(stationWith(0.006), fitOf(2.0), 0.0, plateProfile()));
  EXPECT_FALSE(isSameSurface(stationWith(0.004), fitOf(2.0), 0.0, plateProfile()));
  EXPECT_TRUE(isSameSurface(stationWith(0.004), fitOf(2.0, 0.001), 0.0, plateProfile()));
  auto few = stationWith(0.004);
  few.erase(few.begin() + 41, few.end());  // five beyond edge and blur, at 72 mm
  EXPECT_TRUE(isSameSurface(few, fitOf(2.0), 0.0, plateProfile()));
}

TEST(IsSameSurface, TheStepIsLookedForThreeCentimetresBesideTheEdge) {
  auto raised = stationWith(0.010);
  for (FootPoint& p : raised) p.z += p.d > 0.082 && p.d < 0.102 ? 0.008 : 0.0;
  EXPECT_FALSE(isSameSurface(raised, fitOf(2.0), 0.0, plateProfile()));
}

/// A station of which so many points lie on the ringwall beyond, and three times as many hang over it.
bool isSameUnder(std::size_t in_place, double height) {
  std::vector<FootPoint> points = stationWith(0.010);
  points.resize(36 + in_place);
  for (std::size_t i = 0; i < 3 * in_place; ++i)
    points.push_back({0.0, 0.075 + 0.0005 * static_cast<double>(i), 2.0 + height});
  return isSameSurface(points, fitOf(2.0), 0.0, plateProfile());
}

TEST(IsSameSurface, WhatHangsOverWhatIsSeenBelowSaysNothing) {
  EXPECT_TRUE(isSameUnder(12, 0.15));
  EXPECT_TRUE(isSameUnder(12, 0.055 - 0.010));
  EXPECT_FALSE(isSameUnder(12, 0.045 - 0.010)) << "may be soil that goes on over the edge";
  EXPECT_TRUE(isSameUnder(6, 0.15));
  EXPECT_FALSE(isSameUnder(5, 0.15));
}

TEST(IsSameSurface, AStepOfThreeMillimetresIsOne) {
  const auto over = [](double drop) {
    FootProfile profile = plateProfile();
    for (double& z : profile.height) z = z < 0.0 ? -drop : 0.0;
    return isSameSurface(stationWith(drop - 0.002), fitOf(2.0, 0.0001), 0.0, profile);
  };
  EXPECT_TRUE(over(0.0029));
  EXPECT_FALSE(over(0.0031));
}

TEST(IsSameSurface, IsMeasuredFromTheBandsOffset) {
  FootProfile profile = plateProfile();
  profile.offset = 0.020;
  for (double& z : profile.height) z += 0.020;
  EXPECT_TRUE(isSameSurface(stationWith(0.010), fitOf(2.0), 0.0, profile));
}

TEST(IsSameSurface, UprightFacesAndTooFewPointsBeyondSayNothing) {
  FootProfile profile = plateProfile();
  const auto off = stationWith(0.040);
  EXPECT_FALSE(isSameSurface(off, fitOf(2.0), 0.0, profile));
  EXPECT_TRUE(isSameSurface({off.begin(), off.begin() + 40}, fitOf(2.0), 0.0, profile));  // ends 80 mm out
  std::fill(profile.spread.begin() + 22, profile.spread.end(), 0.005);
  EXPECT_TRUE(isSameSurface(off, fitOf(2.0), 0.0, profile));
}

/// A station whose ringwall ends so far from the shell, where a face goes down to the ground.
std::vector<FootPoint> stationWithFaceAt(double end) {
  std::vector<FootPoint> points = stationWith(0.010);
  for (FootPoint& p : points) p.z -= p.d > end ? 0.4 : 0.0;
  return points;
}

TEST(IsSameSurface, ARingwallMayBeNarrowerThanElsewhere) {
  EXPECT_TRUE(isSameSurface(stationWithFaceAt(0.093), fitOf(2.0), 0.0, plateProfile()));
  EXPECT_TRUE(isSameSurface(stationWithFaceAt(0.084), fitOf(2.0), 0.0, plateProfile()));
  EXPECT_FALSE(isSameSurface(stationWithFaceAt(0.082), fitOf(2.0), 0.0, plateProfile())) << "five points show it";
}

TEST(IsSameSurface, WhatLiesOnALipFarBelowWhichTheRingwallEndsIsNone) {
  std::vector<FootPoint> points = stationWithFaceAt(0.093);
  for (FootPoint& p : points) p.z -= p.d > 0.065 ? 0.025 : 0.0;  // of 25 mm
  EXPECT_FALSE(isSameSurface(points, fitOf(2.0), 0.0, plateProfile()));
  points = stationWithFaceAt(0.087);  // eight in place, as many a little lower
  for (int i = 0; i < 8; ++i) points.push_back({0.0, 0.075 + 0.003 * i, 2.0 - 0.040});
  EXPECT_FALSE(isSameSurface(points, fitOf(2.0), 0.0, plateProfile()));
}

}  // namespace tank_datum::same_surface_test
