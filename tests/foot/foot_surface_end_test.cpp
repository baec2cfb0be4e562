#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "foot/foot_profile.h"
#include "foot/section_end.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_surface_end_test {

/// Where the surface beside the shell ends, in a section of a hundred bins of 3 mm without noise [m].
template <typename Section>
double endOf(const Section& section) {
  std::vector<FootPoint> points;
  for (int bin = 0; bin < 100; ++bin) {
    for (int i = 0; i < 120; ++i)
      points.push_back({0.0, 0.003 * (bin + (i + 0.5) / 120), section(0.003 * (bin + 0.5))});
  }
  return stackProfile({points}, {0.0}, {0.3, 0.001, 0.013}).edge;
}

TEST(StackProfile, AGrooveOfThreeCentimetresEndsTheSurfaceOneOfNineMillimetresDoesNot) {
  const auto groove = [](double width) {  // 4 mm deep, 150 mm from the shell
    return [width](double d) { return d > 0.15 && d < 0.15 + width ? -0.004 : 0.0; };
  };
  EXPECT_NEAR(endOf(groove(0.009)), 0.3, 0.001);
  EXPECT_NEAR(endOf(groove(0.030)), 0.15, 0.010);
}

/// Where the surface is taken to end that is so high above what lies beyond, and comes down to it evenly.
double endOfRamp(double high, double width, double end) {
  return endOf([=](double d) { return high * std::min(1.0, std::max(0.0, (end - d) / width)); });
}

TEST(StackProfile, WhatComesDownByAQuarterCentimetreIsNoPartOfWhatLiesBeyond) {
  EXPECT_NEAR(endOfRamp(0.0020, 0.06, 0.08), 0.3, 0.001);
  EXPECT_NEAR(endOfRamp(0.0045, 0.06, 0.08), 0.08, 0.003);
}

TEST(StackProfile, WhatComesDownWithinAFifthOfTheReachIsABlendWithTheShell) {
  EXPECT_NEAR(endOfRamp(0.006, 0.03, 0.05), 0.3, 0.001);
  EXPECT_NEAR(endOfRamp(0.006, 0.06, 0.07), 0.07, 0.003);
}

/// A lip of 4.5 mm whose edge does not follow the shell's lobes comes down over as little as a blend does.
TEST(StackProfile, WhatIsLevelBesideTheShellIsNoBlendThoughItComesDownAsSteeply) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.0024);
  std::vector<FootPoint> points;
  for (int i = 0; i < 12000; ++i) {
    const double d = 0.3 * (i + 0.5) / 12000, lip = 0.0045 * std::clamp((0.056 - d) / 0.020, 0.0, 1.0);
    points.push_back({0.0, d, lip - 0.006 * d + noise(random)});
  }
  EXPECT_LT(stackProfile({points}, {0.0}, {0.3, 0.003, 0.013}).band_to, 0.045);
}

/// The section of a pad without noise, so many points on 3 mm of it, below a shell of 20 000.
FootProfile sparsePad(int points, bool arc = false) {
  std::vector<FootPoint> section;
  for (int i = 0; i < 20000; ++i) section.push_back({0.0, 0.001, 0.25 * (i + 0.5) / 20000});
  for (int i = 0; i < 95 * points; ++i) {
    const double d = 0.015 + 0.003 * (i + 0.5) / points;
    section.push_back({0.0, d, -0.03 * d});
  }
  return stackProfile({section}, {0.0}, {0.3, 0.001, 0.013, arc});
}

TEST(StackProfile, WhereBinsHoldTooFewPointsOfTheGroundTheyAreWiderWhateverTheShellHolds) {
  EXPECT_NEAR(sparsePad(11).bin, 0.003, 1e-12);
  const FootProfile wider = sparsePad(6);
  EXPECT_NEAR(wider.bin, 0.006, 1e-12);
  EXPECT_NEAR(wider.band_to, 0.3, 0.007);
  EXPECT_NEAR(wider.slope, -0.03, 1e-4);
}

TEST(StackProfile, BinsAreWidenedToATwentyFifthOfTheReachAndNotOfAnArc) {
  EXPECT_NEAR(sparsePad(2).bin, 0.012, 1e-12);
  EXPECT_NEAR(sparsePad(6, true).bin, 0.003, 1e-12);
}

/// Which surface the first 20 of 40 bins of 3 mm are, level ones, with the others so much lower.
Surface surfaceAbove(double drop, const BinLine& own) {
  FootProfile profile;
  profile.bin = 0.003, profile.noise = 0.0005;
  for (int bin = 0; bin < 40; ++bin) profile.height.push_back(bin < 20 ? 0.0 : -drop);
  FootScales scales{0.3, 0.001, 0.013};
  scales.arc = true;
  return surfaceOf(profile, 5, 19, own, scales);
}

TEST(SurfaceOf, WhatLiesThreeMillimetresOffTheLineIsAnotherSurface) {
  EXPECT_EQ(surfaceAbove(0.0029, {0.0, 0.0}), Surface::Foundation);
  EXPECT_EQ(surfaceAbove(0.0031, {0.0, 0.0}), Surface::AnnularPlate);
}

TEST(SurfaceOf, WhatLiesBeyondIsOnNoLineThatTooFewBinsTell) {
  EXPECT_EQ(surfaceAbove(0.0, {0.0, kUnknown}), Surface::AnnularPlate);
}

TEST(SurfaceOf, AGapBelowTheLineAndACrownAboveItAreOffItTogether) {
  FootProfile profile;
  profile.bin = 0.003, profile.noise = 0.0005;
  for (int bin = 0; bin < 100; ++bin) profile.height.push_back(bin < 20 ? 0.0 : bin < 25 ? -0.010 : 0.010);
  EXPECT_EQ(surfaceOf(profile, 5, 19, {0.0, 0.0}, {0.3, 0.001, 0.013}), Surface::AnnularPlate);
}

/// The slope seen beyond a lip whose bins hold 120 points each, of something that rises by 0.08 m/m and holds so many.
double slopeBeyondOf(int points) {
  std::vector<FootPoint> section;
  for (int bin = 0; bin < 100; ++bin) {
    const int count = bin < 20 ? 120 : points;
    for (int i = 0; i < count; ++i) {
      const double d = 0.003 * (bin + (i + 0.5) / count), z = bin < 20 ? 0.0 : 0.08 * (d - 0.06) - 0.015;
      section.push_back({0.0, d, z + 0.0005 * (i % 5 - 2)});
    }
  }
  return stackProfile({section}, {0.0}, {0.3, 0.001, 0.013}).slope_beyond;
}

TEST(SlopeBeyond, WhatIsSeenAFifthAsDenselyAsTheLipIsNoSurface) {
  EXPECT_EQ(slopeBeyondOf(24), 0.0);
  EXPECT_NEAR(slopeBeyondOf(48), 0.08, 0.005);
}

/// A lip of 65 mm on a level ringwall so wide with it. Points within so far of an edge are lifted or lowered by up to
/// 2 mm; of the ringwall's face so much is seen.
FootProfile onRingwall(double width, double blend, double face = 0.3) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0.0, 0.0005);
  std::vector<FootPoint> points;
  for (int i = 0; i < 24000; ++i) {
    const double d = 0.3 * (i + 0.5) / 24000;
    const double lifted = std::max(0.0, 1.0 - (d - 0.065) / blend), lowered = std::max(0.0, 1.0 - (width - d) / blend);
    const double z = d < 0.065 ? 0.0 : d > width ? -0.25 : -0.010 + 0.002 * (lifted - lowered);
    if (d < width + face) points.push_back({0.0, d, z + noise(random)});
  }
  return stackProfile({points}, {0.0}, {0.3, 0.001, 0.013});
}

TEST(SlopeBeyond, TheTopOfARingwallIsReadThreeCentimetresClearOfItsEdges) {
  for (const double face : {0.3, 0.006}) {
    const FootProfile profile = onRingwall(0.180, 0.038, face);
    EXPECT_NEAR(profile.slope_beyond, 0.0, 3.0 * profile.sigma_beyond) << face;
    EXPECT_NEAR(profile.slope_beyond, 0.0, 0.005) << face;
    EXPECT_LT(profile.sigma_beyond, 0.01) << face;
  }
}

TEST(SlopeBeyond, WhereEdgesReachEverywhereATopIsLevelToFiveHundredths) {
  const FootProfile profile = onRingwall(0.139, 0.030);
  EXPECT_NEAR(profile.slope_beyond, 0.0, 0.01);
  EXPECT_NEAR(profile.sigma_beyond, 0.05, 0.005);
}

TEST(SlopeBeyond, AnUnevenTopTellsNoBetterThanTopsAre) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0.0, 0.0005);
  std::vector<FootPoint> points;
  for (int i = 0; i < 24000; ++i) {
    const double d = 0.3 * (i + 0.5) / 24000, wave = 0.0015 * std::sin(d / 0.002);
    points.push_back({0.0, d, noise(random) + (d < 0.065 ? 0.0 : d > 0.155 ? -0.25 : -0.012 - 0.04 * d + wave)});
  }
  const FootProfile profile = stackProfile({points}, {0.0}, {0.3, 0.001, 0.013});
  EXPECT_EQ(profile.slope_beyond, 0.0);
  EXPECT_EQ(profile.sigma_beyond, 0.05);
}

TEST(SlopeBeyond, ATopThatEndsBeyondTheSectionIsKnown) { EXPECT_EQ(onRingwall(0.4, 0.03).sigma_beyond, 0.0); }

TEST(FootProfile, SaysThatNothingIsKnownYet) {
  EXPECT_FALSE(FootProfile().valid());
  EXPECT_EQ(FootProfile().surface, Surface::Unknown);
}

TEST(Surface, NamesAreThoseOfTheFiles) {
  EXPECT_STREQ(nameOf(Surface::Unknown), "unknown");
  EXPECT_STREQ(nameOf(Surface::Foundation), "foundation");
  EXPECT_STREQ(nameOf(Surface::AnnularPlate), "annular_plate");
  EXPECT_STREQ(nameOf(Surface::Ringwall), "ringwall");
}

/// A lip that ends at 36 mm, so high above what lies between 1.5 and 2.5 times as far out; another level before and
/// beyond.
FootProfile lipAbove(double height, double before, double beyond) {
  FootProfile lip;
  lip.bin = 0.003, lip.edge = 0.036, lip.surface = Surface::AnnularPlate;
  for (int i = 0; i < 100; ++i) {
    const double d = 0.003 * (i + 0.5);
    lip.height.push_back(d < 0.036 ? 0.0 : d < 0.054 ? before : d < 0.090 ? -height : beyond);
  }
  return lip;
}

constexpr double kFootReach = 0.5;  // [m]

TEST(HeightOfPipe, IsOfWhatStandsOutLessThanOnceAndAHalfItsHeight) {
  EXPECT_NEAR(heightOfPipe(lipAbove(0.025, -0.025, -0.025), kFootReach), 0.025, 1e-12);
  EXPECT_EQ(heightOfPipe(lipAbove(0.023, -0.023, -0.023), kFootReach), 0.0) << "a thick plate";
  FootProfile foundation = lipAbove(0.025, -0.025, -0.025);
  foundation.surface = Surface::Foundation;
  EXPECT_EQ(heightOfPipe(foundation, kFootReach), 0.0);
}

TEST(HeightOfPipe, AFlatLipOverGroutThatIsSetBackIsNone) {
  const auto with = [](double band_to, double overhang) {
    FootProfile lip = lipAbove(0.030, -0.030, -0.030);
    lip.band_from = 0.010, lip.band_to = band_to, lip.overhang = overhang;
    return heightOfPipe(lip, kFootReach);
  };
  EXPECT_EQ(with(0.029, 0.036), 0.0);
  EXPECT_NEAR(with(0.027, 0.036), 0.030, 1e-12);
  EXPECT_NEAR(with(0.029, 0.0), 0.030, 1e-12);
}

TEST(HeightOfPipe, IsOverWhatLiesClearOfItsFaceAndNearby) {
  EXPECT_NEAR(heightOfPipe(lipAbove(0.030, -0.010, -0.2), kFootReach), 0.030, 1e-12);
  EXPECT_EQ(heightOfPipe(lipAbove(kUnknown, -0.030, -0.030), kFootReach), 0.0) << "hidden there";
}

TEST(HeightOfPipe, IsSixCentimetresAtMost) {
  EXPECT_NEAR(heightOfPipe(lipAbove(0.058, -0.058, -0.058), kFootReach), 0.058, 1e-12);
  EXPECT_EQ(heightOfPipe(lipAbove(0.062, -0.062, -0.062), kFootReach), 0.0) << "the edge of a ringwall";
}

}  // namespace tank_datum::foot_surface_end_test
