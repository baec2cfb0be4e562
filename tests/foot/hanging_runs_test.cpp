#include <gtest/gtest.h>

#include <algorithm>

#include "foot/foot_banks.h"
#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::hanging_runs_test {

using namespace made_feet;

constexpr int kFirst = 40, kLast = 60;

/// Whether stations 40 to `last` hang, 30 mm high, where the shell beside them is seen down to so far below them.
bool hangs(double before, double after, int last = kLast, int seen = 10, int points = 40,
           const FootProfile& surface = {}) {
  MadeFoot made;
  std::vector<double> levels(360, kUnknown);
  for (int s = kFirst; s <= last; ++s) levels[static_cast<std::size_t>(s)] = 0.030;
  const auto add = [&](int station, double below) {
    for (int i = 0; i < points; ++i) {
      const double share = (i + 0.5) / points;
      made.add((station + 0.4 - 0.8 * share) * made.step(), 0.0, 0.050 - (0.020 + below) * share);
    }
  };
  for (int k = 1; k <= 10; ++k) add(kFirst - k, before), add(last + k, after);
  Foot& foot = made.foot();
  for (int s = 0; s < 360; ++s)
    foot.shell_seen[static_cast<std::size_t>(s)] = s > kFirst - 1 - seen && s <= last + seen;
  return findHangingRuns(foot, surface, levels)[kFirst + 1];
}

TEST(FindHangingRuns, TheShellCannotGoOnBelowWhatItStandsOn) {
  EXPECT_TRUE(hangs(0.020, 0.020));
  EXPECT_FALSE(hangs(0.0, 0.0));
}

TEST(FindHangingRuns, AHundredthOfTheReachAndTheNoiseAreAllowed) {
  EXPECT_FALSE(hangs(0.0105, 0.0105));  // 5 mm, 1 mm and three noises of 1 mm, then a fifth of the shell above
  EXPECT_TRUE(hangs(0.0165, 0.0165));
}

TEST(FindHangingRuns, APlateMayBeCutOffBesideARun) {
  const auto hangs_beside = [](double below, double thick) {
    FootProfile plate;
    plate.bin = 0.003, plate.edge = 0.054, plate.surface = Surface::AnnularPlate;
    for (int i = 0; i < 100; ++i) plate.height.push_back(0.003 * (i + 0.5) < plate.edge ? 0.0 : -thick);
    return hangs(below, below, kLast, 10, 40, plate);
  };
  EXPECT_FALSE(hangs_beside(0.0225, 0.012));
  EXPECT_TRUE(hangs_beside(0.0285, 0.012));
  EXPECT_FALSE(hangs_beside(0.0395, 0.029));
  EXPECT_TRUE(hangs_beside(0.0395, 0.031)) << "no plate is so thick";
  EXPECT_FALSE(hangs_beside(0.0105, -0.012)) << "before a crown";
}

TEST(FindHangingRuns, AFootThatLiesNotMuchLowerMayEndTheShell) {
  EXPECT_TRUE(hangs(0.0145, 0.0145));  // a quarter of a fiftieth of the reach
  EXPECT_FALSE(hangs(0.0107, 0.0107));
}

TEST(FindHangingRuns, ADatumMayDipBesideARunByFiveThousandths) {
  const auto hangs_over = [](double falls) -> bool {  // so much from station to station, each 0.17 m wide
    MadeFoot made;
    std::vector<double> levels(360, kUnknown);
    for (int s = kFirst; s <= kLast; ++s) levels[static_cast<std::size_t>(s)] = 0.030;
    for (int k = 1; k <= 10; ++k) {
      for (int i = 0; i < 40; ++i) {
        const double height = 0.050 - (0.020 + falls * k) * (i + 0.5) / 40;
        for (const int station : {kFirst - k, kLast + k})
          made.add((station + 0.01 * (i - 20)) * made.step(), 0.0, height);
      }
    }
    return findHangingRuns(made.foot(), {}, levels)[kFirst + 1];
  };
  EXPECT_FALSE(hangs_over(0.0044));
  EXPECT_TRUE(hangs_over(0.0052));
}

TEST(FindHangingRuns, StationsBesideTellTogetherWhereEachSeesFewPoints) {
  EXPECT_TRUE(hangs(0.020, 0.020, kLast, 10, 10));
  EXPECT_FALSE(hangs(0.020, 0.020, kLast, 3, 4));  // three points in all
}

TEST(FindHangingRuns, OneEndIsEnoughForASixthOfTheRing) {
  EXPECT_TRUE(hangs(0.020, 0.0, kFirst + 55));
  EXPECT_FALSE(hangs(0.020, 0.0, kFirst + 65));
  EXPECT_TRUE(hangs(0.020, 0.020, kFirst + 65));
}

TEST(FindHangingRuns, HalfTheRingIsNoBank) {
  EXPECT_TRUE(hangs(0.020, 0.020, kFirst + 170));
  EXPECT_FALSE(hangs(0.020, 0.020, kFirst + 190));
}

TEST(FindHangingRuns, ThreeStationsBesideAnEndSaySo) {
  EXPECT_FALSE(hangs(0.020, 0.020, kLast, 2));
  EXPECT_TRUE(hangs(0.020, 0.020, kLast, 3));
}

TEST(FindHangingRuns, AWholeRingHasNoEnds) {
  MadeFoot made;
  made.addAll(40, -0.001, 0.001, [](double) { return -0.01; });
  const std::vector<bool> hanging = findHangingRuns(made.foot(), {}, std::vector<double>(360, 0.0));
  EXPECT_EQ(std::count(hanging.begin(), hanging.end(), true), 0);
}

}  // namespace tank_datum::hanging_runs_test
