#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_slopes_test {

using namespace made_feet;

/// What is learnt where the section is that of a surface level up to its edge, in bins of 3 mm, and so beyond.
/// @param seen_to  from where on up to the edge nothing is seen [m]
FootPriors learnt(MadeFoot& made, Surface surface, double edge, double seen_to) {
  FootSections sections;
  FootProfile& whole = sections.whole;
  whole.bin = 0.003, whole.band_from = 0.015, whole.band_to = seen_to, whole.edge = edge;
  whole.blur = 0.004, whole.noise = 0.0005, whole.surface = surface;
  for (int bin = 0; bin < 100; ++bin) {
    const double d = middle(whole, static_cast<std::size_t>(bin));
    whole.height.push_back(d < seen_to ? 0.0 : d < edge ? kUnknown : 0.020);
  }
  sections.stations = 360;
  const FootElevations level{{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)};
  return learnPriors(made.foot(), level, sections);
}

/// The slopes of a pad that falls by 0.005 m/m, and by more over a third of the ring; a quarter of it is not seen.
/// @param uneven  what slopes are off that over twenty degrees each
FootPriors padUnderSoil(double more, double uneven = 0.0) {
  MadeFoot made;
  for (int s = 0; s < 270; ++s) {
    const double slope = -0.005 - (s < 120 ? more : 0.0) + (s / 20 % 2 == 0 ? uneven : -uneven);
    made.addStation(s, 40, 0.02, 0.28, [&](double d) { return slope * d; });
  }
  return learnt(made, Surface::Foundation, 0.3, 0.3);
}

TEST(LearnPriors, SoilThatFallsMoreSteeplyOverAThirdOfTheRingTiltsNoPad) {
  const FootPriors priors = padUnderSoil(0.017);
  EXPECT_NEAR(priors.slope[60], -0.005, 0.001);
  EXPECT_NEAR(priors.slope[200], -0.005, 0.001);
  EXPECT_NEAR(priors.sigma_slope[200], 0.003, 1e-5);
}

TEST(LearnPriors, APadMayFallByEightMillimetresAMetreMoreThanElsewhere) {
  EXPECT_LT(padUnderSoil(0.008).slope[60], -0.010);
}

TEST(LearnPriors, AnUnevenPadMayFallByMore) { EXPECT_LT(padUnderSoil(0.017, 0.010).slope[60], -0.012); }

TEST(LearnPriors, WhatRisesOverAQuarterOfTheRingTiltsNoPad) {
  const FootPriors priors = padUnderSoil(-0.03);
  EXPECT_NEAR(priors.slope[60], -0.005, 0.001);
  EXPECT_NEAR(priors.slope[200], -0.005, 0.001);
}

/// The slopes of a pad that is uneven by so much to either side over ten degrees each, of which half is seen.
FootPriors halfOfPad(double uneven) {
  MadeFoot made;
  for (int s = 0; s < 180; ++s) {
    const double slope = (s + 5) / 10 % 2 == 0 ? uneven : -uneven;
    made.addStation(s, 40, 0.02, 0.28, [&](double d) { return slope * d; });
  }
  return learnt(made, Surface::Foundation, 0.3, 0.3);
}

TEST(LearnPriors, WhereNoPadIsSeenItsSlopeIsKnownLess) {
  const FootPriors priors = halfOfPad(0.003);
  EXPECT_GT(priors.sigma_slope[270], 1.25 * priors.sigma_slope[90]);
}

TEST(LearnPriors, ALipWhoseEdgeACrownHidesIsLevelAmidWhatIsSeenOfIt) {
  MadeFoot made;
  made.addAll(40, 0.0155, 0.0385, [](double) { return 0.0; });
  const FootPriors priors = learnt(made, Surface::AnnularPlate, 0.165, 0.039);
  EXPECT_NEAR(priors.blends.level_at, 0.5 * (kScales.weld + 0.039), 1e-9);
}

/// What the slopes of a lip differ by beyond their errors that swing by so much in waves of so many stations.
double unevenLip(double by, double stations) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double slope = by * std::sin(kTwoPi * s / stations);
    made.addStation(s, 40, 0.0155, 0.0585, [slope](double d) { return slope * (d - 0.035); });
  }
  return learnt(made, Surface::AnnularPlate, 0.165, 0.060).uneven;
}

TEST(LearnPriors, SlopesOfALipThatChangeFromWindowToWindowAreUneven) {
  EXPECT_NEAR(unevenLip(0.01, 13.0), 0.0065, 0.0025);
  EXPECT_LT(unevenLip(0.01, 180.0), 0.001);
  EXPECT_LT(unevenLip(0.0, 13.0), 0.001);
}

/// Of how many of forty lips the slopes are uneven that swing by so much, seen by noisy points.
int unevenOfForty(double by) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.0005);
  int uneven = 0;
  for (int ring = 0; ring < 40; ++ring) {
    MadeFoot made;
    for (int s = 0; s < 360; ++s) {
      const double slope = by * std::sin(kTwoPi * s / 13.0);
      made.addStation(s, 40, 0.0155, 0.0585, [&](double d) { return slope * (d - 0.035) + noise(random); });
    }
    uneven += learnt(made, Surface::AnnularPlate, 0.165, 0.060).uneven > 0.0;
  }
  return uneven;
}

TEST(LearnPriors, SlopesAreSeldomUnevenByChance) {
  EXPECT_EQ(unevenOfForty(0.0), 0);
  EXPECT_GT(unevenOfForty(0.0080), 20);
}

TEST(LearnPriors, BeamsThatMeetACrownBesideALipMayHaveRaisedItsEnd) {
  MadeFoot made;
  made.addAll(40, 0.0155, 0.0585, [](double) { return 0.0; });
  const FootPriors beside = learnt(made, Surface::AnnularPlate, 0.060, 0.060);
  const FootPriors apart = learnt(made, Surface::AnnularPlate, 0.165, 0.060);
  EXPECT_GT(beside.sigma_slope[7], 2.0 * apart.sigma_slope[7]);
}

}  // namespace tank_datum::foot_slopes_test
