#include "foot/wide_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/made_feet.h"

namespace tank_datum::wide_slope_test {

using namespace made_feet;

FootSections padSections() {
  FootSections sections;
  FootProfile& whole = sections.whole;
  whole.bin = 0.003, whole.band_from = 0.015, whole.band_to = 0.28, whole.edge = 0.3;
  whole.blur = 0.004, whole.noise = 0.0002, whole.surface = Surface::Foundation;
  whole.height.assign(100, 0.0);
  sections.stations = 360;
  return sections;
}

/// A level pad that windows of ten degrees show by one row of points each, whose range noise moves them along rays that
/// fall by 0.05 to the shell, which is seen as densely as by such rays; but for every so many, which show many rows.
FootPriors learntOfRows(int every) {
  MadeFoot made;
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0.0, kScales.shell_noise);
  std::uniform_real_distribution<double> within(0.05, 0.27), beside(-0.45, 0.45);
  for (int s = 0; s < 360; ++s) {
    const bool rows = every > 0 && (s + 5) / 10 % 36 % every == 0;
    for (int i = 0; i < 66; ++i) made.add((s + beside(generator)) * made.step(), 0.0, 0.05 + 0.2 * (i + 0.5) / 66.0);
    for (int i = 0; i < 8; ++i) {
      const double along = noise(generator), d = rows ? within(generator) : 0.15 + 0.02 * std::sin(0.17 * s);
      made.add((s + beside(generator)) * made.step(), d + along, 0.05 * along);
    }
  }
  const FootElevations level{{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)};
  return learnPriors(made.foot(), level, padSections());
}

TEST(LearnWide, WindowsOfOneRowSayNothingWhereSixOthersTell) {
  const FootPriors priors = learntOfRows(6);
  EXPECT_LT(std::abs(priors.slope[60]), 0.003);
  EXPECT_LT(std::abs(priors.slope[90]), 0.003);
  EXPECT_LT(priors.feigned, 0.002);
}

TEST(LearnWide, OfRowsAloneTheStandardErrorHoldsTheRaysSlopeAllRound) {
  const FootPriors priors = learntOfRows(0);
  EXPECT_GT(priors.feigned, 0.01);
  for (const std::size_t i : {0U, 90U, 180U, 270U}) {
    EXPECT_LT(std::abs(priors.slope[i]), 2.0 * priors.sigma_slope[i]) << priors.sigma_slope[i];
    EXPECT_GE(priors.sigma_slope[i], priors.feigned);
  }
}

/// Priors of a floor that rises from the shell by 0.008, and by another slope at stations 100 to 170.
FootPriors learntOfFloor(double there, bool inside = true) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double slope = s >= 100 && s <= 170 ? there : 0.008;
    made.addStation(s, 60, 0.015, 0.28, [&](double d) { return slope * d; });
  }
  const FootElevations level{{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)};
  Foot& foot = made.foot();
  foot.inside = inside;
  return learnPriors(foot, level, padSections());
}

TEST(LearnWide, APartOfAFloorThatSettledHasASlopeOfItsOwn) {
  const FootPriors priors = learntOfFloor(0.032);
  EXPECT_NEAR(priors.slope[130], 0.032, 0.001);
  EXPECT_LT(priors.sigma_slope[130], 0.005);
  EXPECT_NEAR(priors.slope[300], 0.008, 0.001);
  EXPECT_GT(priors.sigma_slope[105], 0.010) << "between two windows";
  EXPECT_NEAR(learntOfFloor(0.032, false).slope[130], 0.008, 0.004) << "which may be soil outside";
}

TEST(LearnWide, WhatFallsFromAShellMoreThanElsewhereIsNoSettledFloor) {
  EXPECT_NEAR(learntOfFloor(-0.010).slope[130], 0.008, 0.004);
  EXPECT_NEAR(learntOfFloor(0.20).slope[130], 0.008, 0.004) << "nor what rises as no foundation does";
}

TEST(LearnWide, ASlopeWithinThreeStandardErrorsIsTheRings) {
  EXPECT_NEAR(learntOfFloor(0.008 + 0.0085).slope[130], 0.008, 0.002);
  EXPECT_NEAR(learntOfFloor(0.008 + 0.0097).slope[130], 0.0177, 0.002);
}

}  // namespace tank_datum::wide_slope_test
