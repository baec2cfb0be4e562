#include "foot/beam_effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foot/slanting_beams.h"
#include "support/made_feet.h"

namespace tank_datum::beam_effects_test {

using namespace made_feet;

/// Windows on a surface and a shell that rays come to so steeply.
std::vector<RayCounts> windowsOf(double steepness, std::size_t count = 36) {
  RayCounts counts;
  counts.on_shell = 1000.0;
  counts.wide_to = 0.42;
  counts.wide = 0.4 * steepness * counts.on_shell / (0.4 * kReach);
  return std::vector<RayCounts>(count, counts);
}

BeamEffects beamsAt(double steepness) { return findBeamEffects(windowsOf(steepness), 0.02, kReach, 0.001).front(); }

TEST(BeamEffects, ReachAsFarAsHalfTheirFootprint) {
  EXPECT_NEAR(beamsAt(0.05).to, 0.5 * (0.005 + 0.0003 * 34.0) / 0.05, 1e-9);  // as wide as from 34 m away
  EXPECT_NEAR(beamsAt(0.17).to, 0.5 * (0.005 + 0.0003 * 10.0) / 0.17, 1e-9);
}

TEST(BeamEffects, LiftPointsByHalfOfWhatSimulatedFloorsShow) {
  // rows of a floor 38 m away, seen by beams of 4 mm and 0.3 mrad: distance from the shell, lift [m]
  const BeamEffects beams = beamsAt(1.7 / 38.0);
  for (const auto& [d, lift] : std::vector<std::pair<double, double>>{{0.04, 0.0020}, {0.08, 0.0009}, {0.12, 0.0004}}) {
    EXPECT_GT(lift, beams.liftAt(d) - 1e-4) << d;
    EXPECT_LT(lift, 2.0 * beams.liftAt(d) + 3e-4) << d;
  }
  EXPECT_EQ(beams.liftAt(beams.to), 0.0);
  EXPECT_EQ(beams.liftAt(0.3), 0.0);
}

TEST(BeamEffects, ScatterPointsByRangeNoiseAlongThem) { EXPECT_NEAR(beamsAt(0.05).scatter, 5e-5, 1e-9); }

TEST(BeamEffects, AreNotKnownWhereTheShellIsNotSeen) {
  std::vector<RayCounts> windows = windowsOf(0.1);
  for (RayCounts& window : windows) window.on_shell = 3.0;
  const BeamEffects beams = findBeamEffects(windows, 0.02, kReach, 0.001).front();
  EXPECT_EQ(beams.to, 0.0);
  EXPECT_EQ(beams.liftAt(0.0), 0.0);
}

TEST(BeamEffects, OfAWindowWithoutARowAreThoseOfFiveWindows) {
  std::vector<RayCounts> windows = windowsOf(0.1);
  windows[10].wide = windows[10].wide_to = 0.0;
  EXPECT_NEAR(findBeamEffects(windows, 0.02, kReach, 0.001)[10].to, beamsAt(0.08).to, 1e-9);
  EXPECT_NEAR(findBeamEffects(windows, 0.02, kReach, 0.001)[13].to, beamsAt(0.1).to, 1e-9);
}

/// The fit of a surface that rises by 0.002 m/m, seen in rows, whose points are lifted as by beams, for so much.
FootFit fitOfRows(std::initializer_list<double> rows, const BeamEffects& lifting, double share,
                  const BeamEffects& known) {
  std::vector<FootPoint> points;
  for (const double row : rows) {
    for (int i = 0; i < 40; ++i) {
      const double d = row + 2e-4 * (i % 7);
      points.push_back({0.01 * (i - 20), d, 0.002 * d + share * 2.0 * lifting.liftAt(d) + 1e-4 * ((i * 13) % 5 - 2)});
    }
  }
  FootProfile profile;
  profile.bin = 0.003, profile.band_from = 0.015, profile.band_to = 0.28, profile.edge = 0.3, profile.noise = 0.0003,
  profile.misfit = 0.001;
  FootPrior prior;
  prior.slope = 0.002, prior.sigma_slope = 0.1, prior.sigma_bend = 0.01;
  prior.take(known);
  return fitFoundation(points, profile, 0.0, prior);
}

TEST(FitFoundation, LeavesLiftedRowsOutWhereTheOthersTellAsMuch) {
  const BeamEffects beams{0.06, 0.0015, 0.0};
  const FootFit fit = fitOfRows({0.03, 0.10, 0.17, 0.24}, beams, 1.0, beams);
  EXPECT_EQ(fit.points, 120U);
  EXPECT_NEAR(fit.z, 0.0, 1e-4);
  EXPECT_EQ(fit.lifted.z, 0.0);
  EXPECT_EQ(fit.lifted.slope, 0.0);
}

TEST(FitFoundation, HoldsTheLiftOfRowsItNeeds) {
  const BeamEffects beams{0.12, 0.0005, 0.0};
  for (const double share : {0.0, 0.5, 1.0}) {
    const FootFit fit = fitOfRows({0.03, 0.24}, beams, share, beams);
    EXPECT_EQ(fit.points, 80U);
    EXPECT_LT(std::abs(fit.z), 1.2 * fit.sigma) << share;
    EXPECT_LT(std::abs(fit.slope - 0.002), 1.2 * fit.sigma_slope) << share;
    EXPECT_NEAR(fit.lifted.slope, beams.liftAt(0.03) / 0.21, 0.1 * fit.lifted.slope);
    EXPECT_LT(fit.sigma, 2.5 * beams.lift);
  }
  EXPECT_GT(std::abs(fitOfRows({0.03, 0.24}, beams, 1.0, {}).slope - 0.002), 0.002) << "which nothing tells of";
}

}  // namespace tank_datum::beam_effects_test
