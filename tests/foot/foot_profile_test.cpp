#include "foot/foot_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/made_sections.h"

namespace tank_datum::foot_profile_test {

using namespace made_sections;

double flat(double) { return 0.0; }
double plateOnRingwall(double d) { return d < 0.065 ? 0.0 : -0.010; }
double crown(double d) { return d < 0.065 ? 0.0 : d < 0.100 ? -0.010 : d < 0.180 ? 0.015 : -0.035; }

TEST(StackProfile, OfAFlatPadIsLevelToTheEndOfTheSection) {
  const FootProfile profile = MadeFoot(flat).profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::Foundation);
  EXPECT_NEAR(profile.slope, 0.0, 0.001);
  EXPECT_NEAR(profile.offset, 0.0, 0.0001);
  EXPECT_NEAR(profile.edge, 0.3, 0.003);
  EXPECT_NEAR(profile.noise, kNoise, 0.1 * kNoise);
  EXPECT_LT(profile.misfit, 0.00005);
  EXPECT_GE(profile.band_from, kScales.weld);
  EXPECT_LE(profile.band_to, profile.edge);
  EXPECT_GT(profile.band_to - profile.band_from, 0.1);
}

TEST(StackProfile, OfASlopedPadHasItsSlopeAndMeetsTheShellAtTheDatum) {
  for (const double slope : {-0.05, 0.02}) {
    const FootProfile profile = MadeFoot([&](double d) { return slope * d; }).profile();
    ASSERT_TRUE(profile.valid());
    EXPECT_EQ(profile.surface, Surface::Foundation);
    EXPECT_NEAR(profile.slope, slope, 0.001);
    EXPECT_NEAR(profile.offset, 0.0, 0.0002);
  }
}

TEST(StackProfile, IsRelativeToEachStationsDatum) {
  MadeFoot foot(flat);
  for (double& z : foot.datum) z -= 0.003;
  EXPECT_NEAR(foot.profile().offset, 0.003, 0.0001);
}

TEST(StackProfile, LeavesOutStationsWithoutADatum) {
  MadeFoot foot(flat);
  for (std::size_t s = 0; s < 40; ++s) {
    for (FootPoint& p : foot.stations[s]) p.z += 0.02;
    foot.datum[s] = NAN;
  }
  EXPECT_NEAR(foot.profile().offset, 0.0, 0.0002);
}

TEST(StackProfile, APlateOnARingwallIsAnAnnularPlateAndTheBandLiesOnIt) {
  const FootProfile profile = MadeFoot(plateOnRingwall).profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_NEAR(profile.edge, 0.065, 2.0 * profile.bin);
  EXPECT_GE(profile.band_from, kScales.weld);
  EXPECT_LE(profile.band_to, 0.065);
  EXPECT_NEAR(profile.offset, 0.0, 0.0002);
  EXPECT_NEAR(profile.slope, 0.0, 0.001);
}

TEST(StackProfile, ThePlateHasTheSlopeOfTheRingwallBelowIt) {
  const auto sloped = [](double d) { return plateOnRingwall(d) - 0.03 * d; };
  EXPECT_NEAR(MadeFoot(sloped).profile().slope, -0.03, 0.002);
  const auto soil = [](double d) { return d < 0.065 ? 0.0 : -0.10 - 0.05 * d; };  // too deep to carry the plate
  EXPECT_EQ(MadeFoot(soil).profile().surface, Surface::AnnularPlate);
  EXPECT_EQ(MadeFoot(soil).profile().slope, 0.0);
}

TEST(StackProfile, WhatFallsByMoreThanOneInTwoBeyondThePlateIsAFace) {
  const auto beyond = [](double slope) {
    const auto section = [=](double d) { return d < 0.065 ? 0.0 : d < 0.165 ? 0.001 + slope * (d - 0.065) : -0.3; };
    return MadeFoot(section).profile().slope_beyond;
  };
  EXPECT_NEAR(beyond(-0.45), -0.45, 0.03);
  EXPECT_EQ(beyond(-0.53), 0.0);
}

TEST(StackProfile, ThePlateMayEndBelowAHigherThing) {
  const FootProfile profile = MadeFoot([](double d) { return d < 0.065 ? 0.0 : 0.012; }).profile();
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_LE(profile.band_to, 0.065);
}

TEST(StackProfile, ALipWhoseEdgeIsBlurredHasTheSlopeOfWhatItLiesOn) {
  for (const double slope : {0.0, -0.03}) {
    const auto blurred = [=](double d) { return slope * d - 0.0065 * std::clamp((d - 0.030) / 0.035, 0.0, 1.0); };
    const FootProfile profile = MadeFoot(blurred, 400, 0.0015).profile();
    EXPECT_EQ(profile.surface, Surface::AnnularPlate);
    EXPECT_NEAR(profile.slope, slope, 0.003);
    EXPECT_NEAR(profile.offset, 0.0, 0.0005);
    FootScales arc = kScales;
    arc.arc = true;  // goes by the whole ring's
    EXPECT_EQ(MadeFoot(blurred, 400, 0.0015).profile(arc).surface, Surface::Foundation);
  }
}

TEST(StackProfile, ANarrowLipThatLeansIsNoneOfTheWideSurfaceThatItsEdgeIsBlurredInto) {
  const auto leaning = [](double d) { return d < 0.041 ? 0.0064 - 0.09 * d : std::max(0.0, 0.3 * (0.050 - d)); };
  EXPECT_LE(MadeFoot(leaning, 180, 0.0036).profile().band_to, 0.045);
  const auto lifted = [](double d) { return 0.015 * std::exp(-std::max(0.0, d) / 0.010); };  // 4 mm beside the weld
  EXPECT_EQ(MadeFoot(lifted, 180, 0.0036).profile().surface, Surface::Foundation);
}

TEST(StackProfile, AWideSurfaceThatEndsInADropIsARingwall) {
  const FootProfile profile = MadeFoot([](double d) { return d < 0.2 ? 0.0 : -0.25; }).profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::Ringwall);
  EXPECT_NEAR(profile.edge, 0.2, 3.0 * profile.bin);
  EXPECT_LE(profile.band_to, 0.2);
  EXPECT_NEAR(profile.offset, 0.0, 0.0002);
}

TEST(StackProfile, ACrownHigherThanThePlateDoesNotCarryIt) {
  const FootProfile profile = MadeFoot(crown).profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_LE(profile.band_to, 0.065);
  EXPECT_NEAR(profile.offset, 0.0, 0.0002);
  EXPECT_NEAR(profile.slope, 0.0, 0.003);
}

/// Beams that graze a crown's edge lift the outer half of the lip before it.
TEST(StackProfile, ALipWhoseOuterHalfIsLiftedIsABandFromTheShellOn) {
  const auto lifted = [](double d) {
    return d < 0.087 ? 0.0025 * std::clamp((d - 0.014) / 0.042, 0.0, 1.0) : std::min(0.026, 0.011 + 0.3 * (d - 0.087));
  };
  const FootProfile profile = MadeFoot(lifted, 400, 0.0025).profile();
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_LE(profile.band_from, 0.018);
  EXPECT_GT(profile.slope, 0.01);
}

/// Nothing is seen between lip and crown but where the crown's edge blends into it.
TEST(StackProfile, AStrayBinBeyondWhatIsNotSeenIsNoPartOfTheSurface) {
  MadeFoot foot([](double d) { return d < 0.065 ? 0.0 : d < 0.115 ? 0.004 : 0.015; });
  for (auto& station : foot.stations) {
    const auto hidden = [](const FootPoint& p) { return p.d > 0.065 && p.d < 0.109; };
    station.erase(std::remove_if(station.begin(), station.end(), hidden), station.end());
  }
  const FootProfile profile = foot.profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_LE(profile.band_to, 0.066);
  EXPECT_NEAR(profile.slope, 0.0, 0.003);
}

/// The outer third is seen by a twentieth of the points, which scatter twelve times as much, about a slope that few
/// points do not show to be another.
TEST(StackProfile, ABinCountsForItsErrorInTheSlope) {
  MadeFoot foot(flat);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (auto& station : foot.stations) {
    std::vector<FootPoint> seen;
    for (FootPoint p : station) {
      if (p.d > 0.2 && uniform(random) > 0.05) continue;
      if (p.d > 0.2) p.z += 0.006 * normal(random) + 0.04 * (p.d - 0.2);
      seen.push_back(p);
    }
    station = seen;
  }
  const FootProfile profile = foot.profile();
  ASSERT_GT(profile.edge, 0.28);
  EXPECT_NEAR(profile.slope, 0.0, 0.005);
}

TEST(StackProfile, ADripRingAboveThePlateIsIgnored) {
  MadeFoot foot(plateOnRingwall);
  std::mt19937_64 random(6);
  for (std::size_t s = 0; s < foot.stations.size(); ++s) {
    for (int i = 0; i < 120; ++i) {  // twice as dense as the plate below it
      const double d = 0.05 * uniform(random);
      foot.stations[s].push_back({0.0, d, foot.datum[s] + 0.060});
    }
  }
  const FootProfile profile = foot.profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_EQ(profile.surface, Surface::AnnularPlate);
  EXPECT_NEAR(profile.offset, 0.0, 0.0002);
  EXPECT_NEAR(profile.height[10], 0.0, 0.0005);
}

TEST(StackProfile, AStrayPointBelowIsNoLayer) {
  MadeFoot foot(flat);
  for (std::size_t s = 0; s < foot.stations.size(); s += 4)
    foot.stations[s].push_back({0.0, 0.0305, foot.datum[s] - 0.05});
  EXPECT_NEAR(foot.profile().height[10], 0.0, 0.0003);
}

TEST(StackProfile, ABendBesideTheShellIsOutsideTheBandAndTold) {
  const auto blended = [](double d) { return 0.004 * std::exp(-std::max(0.0, d) / 0.010); };  // as mixed pixels lift it
  const FootProfile profile = MadeFoot(blended).profile(), plain = MadeFoot(flat).profile();
  ASSERT_TRUE(profile.valid());
  EXPECT_LT(blended(profile.band_from), 0.0004);
  EXPECT_GT(profile.band_from, plain.band_from);
  EXPECT_NEAR(profile.offset, 0.0, 0.0002);
  EXPECT_GT(profile.misfit, plain.misfit + 0.00005);
}

TEST(StackProfile, TheWeldIsKeptOut) {
  const auto weld = [](double d) { return std::max(0.0, 0.010 - std::max(0.0, d)); };
  EXPECT_NEAR(MadeFoot(weld).profile().offset, 0.0, 0.0002);
  FootScales wider = kScales;
  wider.weld = 0.05;
  EXPECT_GE(MadeFoot(weld).profile(wider).band_from, 0.05);
  EXPECT_LT(MadeFoot(flat).profile().band_from, 0.05);
}

TEST(StackProfile, ScalesWithTheReachAndTheNoiseOfTheShell) {
  FootScales scales = kScales;
  scales.reach = 0.2;
  EXPECT_NEAR(MadeFoot(flat).profile(scales).edge, 0.2, 0.003);
  EXPECT_NEAR(MadeFoot(flat).profile(scales).bin, 0.002, 1e-12);
  scales.shell_noise = 0.004;
  EXPECT_NEAR(MadeFoot(flat).profile(scales).bin, 0.004, 1e-12);
  EXPECT_NEAR(MadeFoot(flat).profile(scales).blur, 0.016, 1e-12);
}

TEST(StackProfile, OfTooLittleIsNotValid) {
  EXPECT_FALSE(stackProfile({}, {}, kScales).valid());
  EXPECT_FALSE(stackProfile({{{0, 0.1, 5}}}, {5.0}, kScales).valid());
  EXPECT_FALSE(MadeFoot([](double d) { return d < 0.02 ? 0.0 : -1.0; }).profile().valid());  // nothing to stand on
}

}  // namespace tank_datum::foot_profile_test
