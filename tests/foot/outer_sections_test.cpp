#include "foot/outer_sections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::outer_sections_test {

using namespace made_feet;

/// Where a foundation ends, in bins of 20 mm, that falls by 0.04 m/m and, 0.3 m from the shell, by a step [m].
std::size_t endBefore(double step, Surface surface = Surface::Foundation) {
  MadeFoot made;
  made.addAll(400, 0.1, 0.5, [&](double d) { return -0.04 * d - (d < 0.3 ? 0.0 : step); });
  FootProfile profile;
  profile.surface = surface;
  const std::vector<double> levels(360, 0.0);
  return sectionsBeyond(made.foot(), profile, levels, std::vector<bool>(360, true)).front().usual.end;
}

TEST(SectionsBeyond, AFoundationEndsABinBeforeItsEdge) {
  EXPECT_EQ(endBefore(0.0), 25U);
  EXPECT_EQ(endBefore(0.0025), 25U);  // three times the noise is 3 mm
  EXPECT_EQ(endBefore(0.0040), 14U);
  EXPECT_EQ(endBefore(-0.0040), 14U);
}

TEST(SectionsBeyond, WhatALipLiesOnMayMoveByItself) { EXPECT_EQ(endBefore(0.0, Surface::AnnularPlate), 3U); }

/// The depth of a station on a level floor where it falls from the shell by so much at the middle of 90 stations.
double depthOfFall(double falls, bool inside) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double slope = s >= 90 && s < 180 ? falls : 0.0;
    made.addStation(s, 400, 0.1, 0.5, [&](double d) { return -slope * d; });
  }
  Foot& foot = made.foot();
  foot.inside = inside;
  const auto all = sectionsBeyond(foot, {}, std::vector<double>(360, 0.0), std::vector<bool>(360, true));
  return SectionSeen(all, 135).depth(0.004).value;
}

TEST(SectionsBeyond, AFloorMayFallHereAndNotThere) {
  EXPECT_GT(depthOfFall(0.020, false), 0.004);
  EXPECT_EQ(depthOfFall(0.020, true), 0.0);
  EXPECT_GT(depthOfFall(0.035, true), 0.0) << "twice as much is a heap's";
  EXPECT_GT(depthOfFall(0.060, true), 0.010);
}

/// The depth of a station on a plate so thick that lies on a level floor up to 0.31 m from the shell, over 30 degrees.
double depthBeyondPlate(double thick) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double on = s >= 120 && s < 150 ? thick : 0.0;
    made.addStation(s, 400, 0.1, 0.5, [&](double d) { return d < 0.31 ? 0.0 : -on; });
  }
  Foot& foot = made.foot();
  foot.inside = true;
  const auto all = sectionsBeyond(foot, {}, std::vector<double>(360, 0.0), std::vector<bool>(360, true));
  return SectionSeen(all, 135).depth(0.004).value;
}

TEST(SectionsBeyond, WhatLiesOnAFloorEndsInAStep) {
  EXPECT_GT(depthBeyondPlate(0.007), 0.005);
  EXPECT_EQ(depthBeyondPlate(0.004), 0.0);
}

/// A ring whose sections are level, known to 1 mm, in bins of which one station shows some, so much lower.
RingSections ringOf(std::size_t bins, const std::vector<std::size_t>& shown, double lower) {
  RingSections ring{std::vector<Section>(1, Section(bins, kUnknown)),
                    {Section(bins, 0.0), Section(bins, 0.001), 0, 0, bins}};
  for (const std::size_t b : shown) ring.own[0][b] = -lower;
  return ring;
}

/// The depth that a section inside has of a step beyond `from`, where it is level before that, known to a spread.
double depthOfStep(std::size_t from, double spread) {
  std::vector<RingSections> all = {ringOf(25, {}, 0.0)};
  for (std::size_t b = 4; b < 25; ++b) all[0].own[0][b] = b < from ? 0.0 : -0.012, all[0].usual.spread[b] = spread;
  all[0].usual.falls = 0.0003;  // 0.015 m/m in bins of 20 mm
  return SectionSeen(all, 0).depth(0.004).value;
}

TEST(SectionsBeyond, TheSlopeBeforeAStepIsKnownToTwoStandardErrors) {
  // bins 4.5 to 14.5: the sum of their squares is 1100; a mean of 1 mm over 33 of it, twice, at 20 bins
  EXPECT_NEAR(depthOfStep(15, 0.001), 0.012 - 2.0 * 0.001 / std::sqrt(1100.0) * 20.0, 0.0002);
  EXPECT_NEAR(depthOfStep(15, 0.002), 0.012 - 2.0 * 0.002 / std::sqrt(1100.0) * 20.0, 0.0004);
}

TEST(SectionSeen, OfAStationThatShowsFewBinsOfAnyWidthTheNarrowestTell) {
  const std::vector<RingSections> all = {ringOf(25, {17, 19, 21}, 0.010), ringOf(12, {9}, 0.010), ringOf(6, {}, 0.0)};
  EXPECT_NEAR(SectionSeen(all, 0).depth(0.004).value, 0.010, 1e-12);
}

/// The depth of a station that shows bins 4 to 24, from one on so much lower; the foundation ends before another.
Depth depthOf(std::size_t from, double lower, std::size_t end, double spread = 0.001) {
  std::vector<RingSections> all = {ringOf(25, {}, 0.0)};
  for (std::size_t b = 4; b < 25; ++b) all[0].own[0][b] = b < from ? 0.0 : -lower;
  all[0].usual.end = end;
  for (std::size_t b = end; b < 25; ++b) all[0].usual.spread[b] = spread;
  return SectionSeen(all, 0).depth(0.004);
}

TEST(SectionSeen, ThePartThatStandsOutMostCounts) {
  const Depth part = depthOf(20, 0.010, 25);  // of all bins 2.4 mm, less than the least
  EXPECT_TRUE(part.of_part);
  EXPECT_NEAR(part.value, 0.010, 1e-12);
  EXPECT_GE(part.from, 20.0 / 25.0);
  const Depth all = depthOf(4, 0.010, 25);
  EXPECT_FALSE(all.of_part);
  EXPECT_NEAR(all.value, 0.010, 1e-12);
}

TEST(SectionSeen, WhatLiesBeyondTheFoundationIsNoPartOfIt) { EXPECT_EQ(depthOf(20, 0.010, 20).value, 0.0); }

TEST(SectionSeen, WhatScattersSaysLittle) {
  EXPECT_NEAR(depthOf(4, 0.008, 20, 0.050).value, 0.008, 0.0001);
  EXPECT_EQ(depthOf(20, 0.080, 25, 0.001).value, 0.080);
}

TEST(SectionSeen, ShowsWhatLiesFartherInTwoBins) {
  const std::vector<RingSections> all = {ringOf(10, {2, 3, 4, 5, 6, 7}, 0.0)};
  EXPECT_TRUE(SectionSeen(all, 0).shows(0.6));
  EXPECT_FALSE(SectionSeen(all, 0).shows(0.7));
}

}  // namespace tank_datum::outer_sections_test
