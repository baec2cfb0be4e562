#include "foot/under_shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::under_shell_test {

using namespace made_feet;

/// What stations see: points before the shell, of the foundation behind it, and of what stands there.
struct Seen {
  int before = 20, behind = 0, through = 0;
  double at = 0.030;           ///< distance of the points before the shell [m]
  double height = 0.0;         ///< of those behind it
  double through_from = 0.15;  ///< height of those that are seen through it
  double through_at = -0.060;  ///< and where
};

FootFit standing() {
  FootFit fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0;
  fit.sigma = 0.0002, fit.noise = 0.0004, fit.half_width = 0.01;
  return fit;
}

/// The stations of a ring of which some see one thing, and the others another.
UnderShell under(const Seen& these, int first = 0, int last = 359, const Seen& others = {}) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const Seen& seen = s >= first && s <= last ? these : others;
    made.addStation(s, seen.before, seen.at - 0.001, seen.at + 0.001, [](double) { return 0.0; });
    made.addStation(s, seen.behind, -0.031, -0.029, [&](double) { return seen.height; });
    made.addStation(s, seen.through, seen.through_at - 0.001, seen.through_at + 0.001,
                    [&](double) { return seen.through_from; });
  }
  return findUnderShell(made.foot(), std::vector<FootFit>(360, standing()), std::vector<double>(360, 0.0));
}

TEST(UnderShell, AShellHidesTheFoundation) {
  EXPECT_EQ(under({}).share, 0.0);
  EXPECT_TRUE(under({}).isOfFew());
}

TEST(UnderShell, AQuarterOfWhatIsSeenBeforeItIsTheLeast) {
  EXPECT_EQ(under({20, 4}).share, 0.0);
  EXPECT_EQ(under({20, 6}).share, 1.0);
  EXPECT_FALSE(under({20, 6}).isOfFew());
}

TEST(UnderShell, IsLookedForATenthOfTheReachAboutTheShell) {
  EXPECT_EQ(under({20, 20, 0, 0.045}).share, 1.0);
  EXPECT_TRUE(std::isnan(under({20, 20, 0, 0.060}).share));
}

TEST(UnderShell, IsLookedForFourHundredthsOfTheReachAboutTheFoundation) {
  EXPECT_EQ(under({20, 20, 0, 0.030, -0.017}).share, 1.0);
  EXPECT_EQ(under({20, 20, 0, 0.030, -0.023}).share, 0.0);
}

TEST(UnderShell, WhatIsSeenThroughAWallFromAFifthOfTheReachOnTellsNothing) {
  EXPECT_EQ(under({20, 20, 20, 0.030, 0.0, 0.085}).share, 1.0);
  EXPECT_TRUE(std::isnan(under({20, 20, 20, 0.030, 0.0, 0.115}).share));
}

TEST(UnderShell, WhatIsFartherBehindAWallThanATenthOfTheReachIsNoPartOfIt) {
  EXPECT_EQ(under({20, 20, 20, 0.030, 0.0, 0.150, -0.045}).share, 1.0);
  EXPECT_TRUE(std::isnan(under({20, 20, 20, 0.030, 0.0, 0.150, -0.055}).share));
}

/// A wall that begins at 0.2 m above the edge of a plate, 0.03 m high, that stands out as far; behind it, in the middle
/// of the hole and higher up, so many points.
double shareUnderHole(double wall_from, int in_hole, int above, int strays = 0) {
  MadeFoot made;
  made.addAll(20, 0.029, 0.031, [](double) { return 0.0; });
  for (double z = 0.005; z < 0.5; z += 0.01) {
    const int points = z < 0.03 || z > wall_from ? 20 : strays;
    made.addAll(points, -0.002, 0.002, [&](double) { return z; });
  }
  made.addAll(in_hole, -0.061, -0.059, [](double) { return 0.045; });
  made.addAll(above, -0.061, -0.059, [](double) { return 0.3; });
  return findUnderShell(made.foot(), std::vector<FootFit>(360, standing()), std::vector<double>(360, 0.0)).share;
}

TEST(UnderShell, WhatIsSeenThroughAHoleBelowAWallIsOfItsFoot) {
  EXPECT_EQ(shareUnderHole(0.2, 20, 0), 1.0);
  EXPECT_EQ(shareUnderHole(0.2, 0, 0), 0.0);
  EXPECT_TRUE(std::isnan(shareUnderHole(0.2, 20, 20)));
}

TEST(UnderShell, AHoleIsATenthOfTheReachHigh) {
  EXPECT_EQ(shareUnderHole(0.09, 20, 0), 1.0);
  EXPECT_EQ(shareUnderHole(0.06, 20, 0), 0.0);
}

TEST(UnderShell, AHoleHoldsStrayPoints) {
  EXPECT_EQ(shareUnderHole(0.2, 20, 0, 1), 1.0);
  EXPECT_EQ(shareUnderHole(0.2, 20, 0, 2), 0.0);
}

TEST(UnderShell, AFloorFartherInThanCladdingIsThickTellsNothing) {
  const auto with_floor = [](double at) {
    MadeFoot made;
    made.addAll(20, 0.029, 0.031, [](double) { return 0.0; });
    made.addAll(20, -0.031, -0.029, [](double) { return 0.0; });
    made.addAll(20, at - 0.001, at + 0.001, [](double) { return 0.0; });
    return findUnderShell(made.foot(), std::vector<FootFit>(360, standing()), std::vector<double>(360, 0.0)).share;
  };
  EXPECT_EQ(with_floor(-0.190), 1.0);
  EXPECT_TRUE(std::isnan(with_floor(-0.210)));
}

TEST(UnderShell, StationsWithinThreeDegreesAreAskedTogether) {
  const UnderShell found = under({4, 4}, 100, 100, {0, 0});
  EXPECT_TRUE(std::isnan(found.share)) << "five points are the fewest";
  const auto seen = under({6, 6}, 100, 100, {0, 0}).seen;
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 7);
  EXPECT_TRUE(seen[97] && seen[103]);
}

TEST(UnderShell, AStationOfItsOwnIsToldAmongOthersThatSeeMore) {
  EXPECT_TRUE(under({6, 6}, 100, 100).seen[100]);
  EXPECT_FALSE(under({6, 6}, 100, 100).seen[101]);
}

TEST(UnderShell, AQuarterOfTheRingIsFew) {
  EXPECT_TRUE(under({20, 20}, 0, 80).isOfFew());
  EXPECT_FALSE(under({20, 20}, 0, 99).isOfFew());
}

TEST(UnderShell, StationsThatDoNotStandAreNotAsked) {
  MadeFoot made;
  made.addAll(20, -0.04, 0.04, [](double) { return 0.0; });
  EXPECT_TRUE(std::isnan(findUnderShell(made.foot(), std::vector<FootFit>(360), std::vector<double>(360, 0.0)).share));
}

}  // namespace tank_datum::under_shell_test
