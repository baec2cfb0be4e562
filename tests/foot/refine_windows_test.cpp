#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/refine.h"
#include "support/made_rings.h"

namespace tank_datum::refine_windows_test {

using namespace made_rings;

constexpr double kRadius = 5.0;

double level(double) { return 0.0; }

/// A shell upon a level pad, each with so many points and this noise.
Ring ringOf(int count, double noise) {
  MadeRing<level> made(9);
  for (int i = 0; i < count; ++i) {
    made.add(kRadius + made.noise(noise), 0.5 * made.any());
    made.add(kRadius + 0.4 * made.any(), made.noise(noise));
  }
  return made.ring;
}

/// Median of the windows that the stations look at [deg].
double windowOf(const Ring& ring, const RefineOptions& options, int count = 360) {
  StationOptions around;
  around.count = count;
  const std::vector<StationDatum> stations = refineStations(ring, levelTank(kRadius), options, around).stations;
  std::vector<double> windows;
  for (const StationDatum& s : stations) {
    if (s.flag == StationFlag::Measured) windows.push_back(toDegrees(s.window));
  }
  EXPECT_GT(windows.size(), 0.9 * count);
  if (windows.empty()) return 0.0;
  std::nth_element(windows.begin(), windows.begin() + static_cast<std::ptrdiff_t>(windows.size() / 2), windows.end());
  return windows[windows.size() / 2];
}

TEST(RefineStations, OfANoisyScanLooksAtTenDegreesOnEitherSideAtMost) {
  RefineOptions options;
  options.widest_window = 100.0;
  // half a degree grows by 1.4 until it is beyond ten
  EXPECT_NEAR(windowOf(ringOf(20'000, 0.008), options), 2.0 * 0.5 * std::pow(1.4, 9), 0.1);
}

TEST(RefineStations, StationsTwoDegreesApartLookAtTheDegreeTheyStandIn) {
  RefineOptions options;
  options.wanted_sigma = 1.0;  // every station is good enough alone
  const Ring ring = ringOf(30'000, 0.0005);
  EXPECT_NEAR(windowOf(ring, options, 180), 1.0, 0.01);
  EXPECT_NEAR(windowOf(ring, options, 360), 1.0, 0.01);
}

TEST(RefineStations, WhatStandsUprightBeforeTheShellIsNoFoundation) {
  Ring ring = ringOf(60'000, 0.0005);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any;
  for (int i = 0; i < 4'000; ++i) {  // a face 80 mm from the shell, over four degrees
    const double a = toRadians(88.0 + 4.0 * any(random)), r = kRadius + 0.08;
    ring.points.push_back({r * std::cos(a), r * std::sin(a), 0.45 * any(random)});
  }
  RefineOptions options;
  options.wanted_sigma = 1.0;
  const std::vector<StationDatum> stations = refineStations(ring, levelTank(kRadius), options, {}).stations;
  EXPECT_LT(*stations[89].n_foundation, *stations[80].n_foundation * 8 / 10);
  EXPECT_NEAR(stations[89].z, 0.0, 0.0005);
}

}  // namespace tank_datum::refine_windows_test
