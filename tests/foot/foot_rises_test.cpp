#include "foot/foot_rises.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_rises_test {

using namespace made_feet;

constexpr std::size_t kLast = 105;  ///< of an arc of six stations in which something else is seen

/// Stations that rise, of a level ring with that arc in it.
struct Ring {
  double radius = kRadius, sigma = 0.0002;  ///< of the shell, and of levels [m]
  Unmeasured reason = Unmeasured::OtherSurface;
  std::vector<double> levels = std::vector<double>(360, 0.0);

  Ring& raise(std::size_t away, std::size_t count, double height) {
    for (std::size_t k = 0; k < count; ++k) levels[kLast + away + k] = height;
    return *this;
  }

  std::vector<bool> rises() const {
    MadeFoot made;
    Foot& foot = made.foot();
    foot.radius = radius;
    FootOutliers outliers{std::vector<Unmeasured>(360, Unmeasured::None), {}, {}, {}, {}};
    std::vector<double> known = levels;
    for (std::size_t i = 100; i <= kLast; ++i) outliers.reasons[i] = reason, known[i] = kUnknown;
    return findRises(foot, outliers, known, std::vector<double>(360, sigma));
  }
};

/// Whether so many stations of a ring are left out that begin so far from the arc.
bool leavesOut(Ring ring, std::size_t away, std::size_t count, double height) {
  return ring.raise(away, count, height).rises()[kLast + away];
}

TEST(FindRises, StationsThatRiseTowardsWhatHidesTheFoundationAreLeftOutWithAllUpToIt) {
  const auto rises = Ring().raise(1, 1, 0.003).raise(2, 1, 0.002).raise(3, 1, 0.0015).rises();
  for (std::size_t i = 0; i < rises.size(); ++i) EXPECT_EQ(rises[i], i > kLast && i <= kLast + 3) << i;
}

TEST(FindRises, BothSidesOfAnArcAreLookedAt) {
  Ring ring;
  ring.levels[99] = 0.003;
  EXPECT_TRUE(ring.rises()[99]);
  EXPECT_FALSE(ring.rises()[kLast + 1]);
}

TEST(FindRises, ADipIsNone) { EXPECT_FALSE(leavesOut({}, 1, 1, -0.003)); }

TEST(FindRises, OnlyBesideArcsInWhichSomethingElseIsSeen) {
  const auto beside = [](Unmeasured reason) { return leavesOut({kRadius, 0.0002, reason}, 1, 1, 0.003); };
  EXPECT_TRUE(beside(Unmeasured::OtherSurface));
  EXPECT_FALSE(beside(Unmeasured::Hidden));
  EXPECT_FALSE(beside(Unmeasured::NoShell));
}

TEST(FindRises, ARiseIsOneOfMoreThanThreeStandardErrors) {
  EXPECT_TRUE(leavesOut({}, 6, 1, 0.0008));
  EXPECT_FALSE(leavesOut({}, 6, 1, 0.00055));
}

TEST(FindRises, CloseToTheArcTheDatumItselfMayDoALittle) {
  EXPECT_TRUE(leavesOut({}, 1, 1, 0.00135));
  EXPECT_FALSE(leavesOut({}, 1, 1, 0.00095));
}

TEST(FindRises, SoilFadesOverTwiceTheReach) {
  EXPECT_TRUE(leavesOut({}, 6, 1, 0.003));
  EXPECT_FALSE(leavesOut({}, 7, 1, 0.003));
}

/// How many stations are left out of an island beside the arc that rises all alike, with nothing near beyond.
std::ptrdiff_t leftOfIsland(std::size_t stations, std::size_t nothing, double height = 0.02) {
  Ring ring;
  ring.raise(1, stations, height).raise(1 + stations, nothing, kUnknown);
  const std::vector<bool> rises = ring.rises();
  return std::count(rises.begin(), rises.end(), true);
}

TEST(FindRises, AnIslandBesideAnArcIsNoMeasureOfItself) {
  EXPECT_EQ(leftOfIsland(10, 7), 10);
  EXPECT_LT(leftOfIsland(10, 3), 10);  // with those beyond, it is none
  EXPECT_LT(leftOfIsland(13, 12), 13);
  EXPECT_EQ(leftOfIsland(10, 7, 0.010), 10);
  EXPECT_EQ(leftOfIsland(10, 7, 0.005), 0);  // a datum may dip by a hundredth of the reach
}

TEST(FindRises, IslandsThatAreMostOfTheRingAreTheRing) {
  const auto left = [](std::size_t others) {
    Ring ring;
    ring.raise(1, 254, kUnknown).raise(1, 10, 0.02).raise(40, others, 0.0);
    std::fill_n(ring.levels.begin(), 100, kUnknown);
    std::fill_n(ring.levels.begin() + 90, 10, 0.02);
    const std::vector<bool> rises = ring.rises();
    return std::count(rises.begin(), rises.end(), true);
  };
  EXPECT_EQ(left(30), 20);
  EXPECT_LT(left(15), 20);
}

TEST(FindRises, OverTwentyDegreesAtMost) {
  EXPECT_TRUE(leavesOut({2.0}, 20, 1, 0.003));
  EXPECT_FALSE(leavesOut({2.0}, 21, 1, 0.003));
}

TEST(FindRises, UpToSixStationsTellTogether) {
  EXPECT_TRUE(leavesOut({2.0, 0.002}, 15, 6, 0.0033));
  EXPECT_FALSE(leavesOut({2.0, 0.002}, 9, 12, 0.0026));
}

}  // namespace tank_datum::foot_rises_test
