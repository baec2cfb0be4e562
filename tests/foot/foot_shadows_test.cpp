#include "foot/foot_shadows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/made_feet.h"
#include "support/rough_surface.h"

namespace tank_datum::foot_shadows_test {

using namespace made_feet;

/// Mean and standard deviation of the heights that rays of a slope meet, evenly spaced, along lines over surfaces.
SeenHeights seenAlong(const Roughness& rough, double steepness) {
  double sum = 0, squares = 0, rays = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const RoughSurface surface(rough.heights, rough.length, 150, seed);
    double last = surface(0.0, 0.0), highest = last;
    for (int i = 1; i < 20000; ++i) {
      const double x = 0.04 * rough.length * i, z = surface(x, 0.0), ray = z + steepness * x;  // the ray through here
      const double weight = std::max(0.0, ray - highest), met = 0.5 * (z + last);              // none in the shadow
      sum += weight * met, squares += weight * met * met, rays += weight;
      highest = std::max(highest, ray);
      last = z;
    }
  }
  const double mean = sum / rays;
  return {mean, std::sqrt(squares / rays - mean * mean)};
}

TEST(SeenHeights, AreThoseThatRaysMeet) {
  const Roughness rough{0.0015, 0.01};  // slopes of 0.15
  for (const double steepness : {0.05, 0.1, 0.15}) {
    const SeenHeights rays = seenAlong(rough, steepness), seen = seenHeights(steepness, rough);
    EXPECT_NEAR(seen.lift, rays.lift, 0.08 * rays.lift) << steepness;
    EXPECT_NEAR(seen.spread, rays.spread, 0.06 * rays.spread) << steepness;
  }
}

TEST(SeenHeights, WhereEveryOtherHeightHidesAreTheGreaterOfTwo) {
  const Roughness rough{0.001, 0.01};
  const double steepness = 1.16 * 0.1 * std::sqrt(2.0) * 0.195183;  // as often hidden as seen
  EXPECT_NEAR(seenHeights(steepness, rough).lift, 0.001 / std::sqrt(kPi), 2e-6);
  EXPECT_NEAR(seenHeights(steepness, rough).spread, 0.001 * std::sqrt(1.0 - 1.0 / kPi), 2e-6);
}

TEST(SeenHeights, FromAboveAreAllAndOfASmoothSurfaceAreItsOwn) {
  EXPECT_NEAR(seenHeights(1.0, {0.001, 0.01}).lift, 0.0, 1e-9);
  EXPECT_NEAR(seenHeights(1.0, {0.001, 0.01}).spread, 0.001, 1e-8);
  EXPECT_EQ(seenHeights(0.1, {}).lift, 0.0);
  EXPECT_TRUE(std::isfinite(seenHeights(0.0, {0.001, 0.01}).lift));
}

TEST(Unshadowed, IsTheSurfaceThatIsSeenSo) {
  for (const double steepness : {0.05, 0.1, 0.2}) {
    const Roughness rough{0.002, 0.012};
    const Roughness seen{seenHeights(steepness, rough).spread, rough.length};
    EXPECT_NEAR(unshadowed(seen, steepness).heights, rough.heights, 0.002 * rough.heights) << steepness;
    EXPECT_EQ(unshadowed(seen, steepness).length, rough.length);
  }
}

constexpr double kSigma = 0.0003;

constexpr int kOnPad = 90;  // points of a station: 300 a metre outwards

/// Stations on a rough pad, seen as steeply as points on the shell make it: other ones from a station on. Rays meet
/// bumps farther out.
std::vector<StationDatum> doubtedStations(const RoughSurface& surface, int on_shell, int on_shell_beyond,
                                          int on_pad_beyond = kOnPad, int beyond = 180) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> along(-0.5, 0.5), across(0.04, 0.26);
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const int count = s < beyond ? on_shell : on_shell_beyond, on_pad = s < beyond ? kOnPad : on_pad_beyond;
    const double steepness = on_pad / 0.3 * 0.2 / std::max(count, 60);
    for (int i = 0; i < on_pad; ++i) {
      const double azimuth = (s + along(random)) * made.step(), d = across(random), z = surface(kRadius * azimuth, d);
      made.add(azimuth, d + z / steepness, z);
    }
    for (int i = 0; i < count; ++i) made.add(s * made.step(), 0.0, 0.0501 + 0.1998 * i / count);
  }
  Foot& foot = made.foot();
  FootPass pass;
  FootProfile& pad = pass.sections.whole;
  pad.bin = 0.003, pad.band_from = 0.0, pad.band_to = pad.edge = 0.3;
  pad.blur = 0.004, pad.noise = 0.0015, pad.surface = Surface::Foundation;
  pass.sections.stations = 360;
  pass.priors.slope.assign(360, 0.0);
  pass.priors.sigma_slope.assign(360, 0.003);
  pass.priors.sigma_bend = 0.003;
  FootFit fit;
  fit.z = 0.0, fit.sigma = kSigma;
  pass.fits.assign(360, fit);
  StationDatum station;
  station.flag = StationFlag::Measured;
  station.z = 0.0, station.sigma_z = kSigma;
  std::vector<StationDatum> stations(360, station);
  stations[7] = {};
  stations[8].flag = StationFlag::Interpolated;
  return withShadowsDoubted(std::move(stations), foot, pass);
}

double doubtAt(const std::vector<StationDatum>& stations, std::size_t station) {
  return std::sqrt(std::pow(stations[station].sigma_z, 2.0) - kSigma * kSigma);
}

TEST(WithShadowsDoubted, SigmasHoldTheLiftOfRaysFromTheSideAndNoStationMoves) {
  const Roughness rough{0.0015, 0.012};
  const auto stations = doubtedStations(RoughSurface(rough.heights, rough.length), 300, 300);  // steepness 0.2
  const double lift = seenHeights(0.64 * 0.2, unshadowed(rough, 0.64 * 0.2)).lift;
  EXPECT_GT(lift, 0.00015);
  for (std::size_t i = 8; i < 360; ++i) {
    EXPECT_NEAR(doubtAt(stations, i), lift, 0.2 * lift) << i;
    EXPECT_EQ(stations[i].z, 0.0);
  }
  EXPECT_TRUE(std::isnan(stations[7].sigma_z));
}

TEST(WithShadowsDoubted, EveryFiveDegreesHaveTheirOwnAndThoseWithoutAShellTheUsual) {
  const RoughSurface surface(0.0015, 0.012);
  const auto two = doubtedStations(surface, 300, 600);
  EXPECT_NEAR(doubtAt(two, 177), doubtAt(two, 100), 1e-6);
  EXPECT_GT(doubtAt(two, 183), 1.3 * doubtAt(two, 177));
  const auto half = doubtedStations(surface, 300, 0);
  EXPECT_NEAR(doubtAt(half, 270), doubtAt(half, 90), 1e-6);
}

TEST(WithShadowsDoubted, WherePointsLieAnEighthAsDenseRaysComeHalfAsSteeplyHoweverFewTheShellShows) {
  const Roughness rough{0.0015, 0.012};
  const auto stations = doubtedStations(RoughSurface(rough.heights, rough.length), 300, 17, 11, 100);
  const double steep = seenHeights(0.64 * 0.2, rough).lift, flat = seenHeights(0.54 * 0.64 * 0.2, rough).lift;
  EXPECT_NEAR(doubtAt(stations, 50) / doubtAt(stations, 250), steep / flat, 0.2 * steep / flat);
}

TEST(WithShadowsDoubted, AFewStationsWithDensePointsOrLittleShellSayNothingOfTheOthers) {
  const RoughSurface surface(0.0015, 0.012);
  const auto few = doubtedStations(surface, 300, 37, 11, 25);  // all as steep
  EXPECT_NEAR(doubtAt(few, 250), doubtAt(few, 10), 0.02 * doubtAt(few, 10));
  const auto hidden = doubtedStations(surface, 300, 75, kOnPad, 300);  // as if four times as steep
  EXPECT_NEAR(doubtAt(hidden, 330), doubtAt(hidden, 100), 0.02 * doubtAt(hidden, 100));
}

TEST(WithShadowsDoubted, ASmoothSurfaceIsNotDoubted) {
  EXPECT_NEAR(doubtAt(doubtedStations(RoughSurface(0.0005, 0.03), 300, 300), 90), 0.0, 1e-6);
}

}  // namespace tank_datum::foot_shadows_test
