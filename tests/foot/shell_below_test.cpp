#include "foot/shell_below.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::shell_below_test {

using namespace made_feet;

constexpr int kFirst = 100, kLast = 130, kMiddle = 115;  // an arc of 31 stations

FootFit fitOf(double sigma, double noise) {
  FootFit fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0;
  fit.sigma = sigma, fit.noise = noise, fit.half_width = 0.05;
  return fit;
}

/// Fits of the stations of an arc upon z = 0, none elsewhere.
std::vector<FootFit> fitsOf(int first, int last, const FootFit& fit = fitOf(0.0002, 0.0004)) {
  std::vector<FootFit> fits(360);
  for (int s = first; s <= last; ++s) fits[static_cast<std::size_t>(s)] = fit;
  return fits;
}

/// Points of the shell at a station, evenly from one height to another.
void addShell(MadeFoot& made, int station, int count, double from, double to) {
  for (int i = 0; i < count; ++i) {
    const double beside = 0.9 * (std::fmod(0.618034 * i, 1.0) - 0.5);
    made.add((station + beside) * made.step(), 0.0, from + (to - from) * (i + 0.5) / count);
  }
}

/// Whether the shell goes on at every station of an arc where it is seen that far below all of them, by points a
/// fiftieth of a millimetre apart.
bool goesOn(double depth, const FootFit& fit = fitOf(0.0002, 0.0004)) {
  constexpr double kApart = 0.00002, kHigh = 0.030;
  MadeFoot made;
  for (int s = kFirst; s <= kLast; ++s) addShell(made, s, static_cast<int>((depth + kHigh) / kApart), -depth, kHigh);
  const std::vector<bool> below = findShellBelow(made.foot(), fitsOf(kFirst, kLast, fit));
  const auto all = std::count(below.begin(), below.end(), true);
  EXPECT_TRUE(all == 0 || all == kLast - kFirst + 1) << all;
  return all > 0;
}

TEST(FindShellBelow, TwoThousandthsOfTheReachBeyondTheBlurAreTheLeast) {
  EXPECT_FALSE(goesOn(0.0016));  // 0.8 mm of blur and 1 mm
  EXPECT_TRUE(goesOn(0.0024));
}

TEST(FindShellBelow, TwoNoisesAreBlur) {
  EXPECT_FALSE(goesOn(0.0045, fitOf(0.0002, 0.002)));
  EXPECT_TRUE(goesOn(0.0056, fitOf(0.0002, 0.002)));
}

TEST(FindShellBelow, ThreeStandardErrorsOfTheLevelsSayNothing) {
  EXPECT_FALSE(goesOn(0.0035, fitOf(0.001, 0.0004)));
  EXPECT_TRUE(goesOn(0.0046, fitOf(0.001, 0.0004)));
}

/// Whether it goes on where it is seen at one height alone below.
bool goesOnAt(double depth) {
  MadeFoot made;
  for (int s = kFirst; s <= kLast; ++s) addShell(made, s, 50, -depth, -depth), addShell(made, s, 100, 0.0, 0.030);
  return findShellBelow(made.foot(), fitsOf(kFirst, kLast))[kMiddle];
}

TEST(FindShellBelow, ThreeHundredthsOfTheReachAreLookedAt) {
  EXPECT_TRUE(goesOnAt(0.012));
  EXPECT_FALSE(goesOnAt(0.025));
}

/// Whether it goes on where one point of it is seen below at so many of the stations, and five above at another.
bool goesOnAtFew(int stations) {
  MadeFoot made;
  for (int s = 0; s < stations; ++s) addShell(made, kFirst + s, 1, -0.008, -0.008);
  addShell(made, kLast, 5, 0.002, 0.012);
  return findShellBelow(made.foot(), fitsOf(kFirst, kLast))[kMiddle];
}

TEST(FindShellBelow, FewPointsAreChance) {
  EXPECT_FALSE(goesOnAtFew(7 + 4));  // seven stations see most of it
  EXPECT_TRUE(goesOnAtFew(7 + 6));
}

/// Whether it goes on at a station where it is seen 20 mm below stations in part of the ring, above only elsewhere.
bool goesOnAtStation(int station, int first, int last, int deep_from, int deep_to) {
  MadeFoot made;
  for (int s = first; s <= last; ++s) {
    const bool deep = s >= deep_from && s <= deep_to;
    addShell(made, s, deep ? 500 : 250, deep ? -0.020 : 0.0, 0.020);
  }
  return findShellBelow(made.foot(), fitsOf(first, last))[static_cast<std::size_t>(station)];
}

TEST(FindShellBelow, WhatAQuarterOfTheStationsSeesIsNotSeenByAll) {
  EXPECT_FALSE(goesOnAtStation(kMiddle, kFirst, kLast, 100, 106));
  EXPECT_TRUE(goesOnAtStation(kMiddle, kFirst, kLast, 100, 108));
}

TEST(FindShellBelow, StationsWithinFifteenDegreesAreLookedAtTogether) {
  EXPECT_TRUE(goesOnAtStation(184, 20, 340, 90, 179));
  EXPECT_FALSE(goesOnAtStation(190, 20, 340, 90, 179));
}

TEST(FindShellBelow, StationsThatDoNotStandSayNothing) {
  MadeFoot made;
  made.addAll(50, -0.001, 0.001, [](double) { return -0.01; });
  const std::vector<bool> below = findShellBelow(made.foot(), std::vector<FootFit>(360));
  EXPECT_EQ(std::count(below.begin(), below.end(), true), 0);
}

/// Where the shell begins at stations that see it by 20 points from 100 mm on, and by others at one height below.
double seenFrom(int others, double height, int points = 20, double noise = 0.0004) {
  MadeFoot made;
  for (int s = kFirst; s <= kLast; ++s) {
    addShell(made, s, points, 0.100, 0.120);
    if (others > 0) addShell(made, s, others, height, height);
  }
  return shellSeenFrom(made.foot(), fitsOf(kFirst, kLast, fitOf(0.0002, noise)));
}

TEST(ShellSeenFrom, IsTheLowestOfItsPointsButTwo) {
  EXPECT_NEAR(seenFrom(0, 0.0), 0.1025, 1e-4);
  EXPECT_NEAR(seenFrom(2, 0.020), 0.1005, 1e-4);
  EXPECT_NEAR(seenFrom(3, 0.020), 0.020, 1e-4);
}

TEST(ShellSeenFrom, PointsOfTheSurfaceAreNoneOfTheShell) {
  EXPECT_NEAR(seenFrom(5, 0.005, 20, 0.002), 0.1025, 1e-4);
  EXPECT_NEAR(seenFrom(5, 0.007, 20, 0.002), 0.007, 1e-4);
}

/// The same where the foot of the shell is seen by points that stand so far before it.
double seenBehind(double before) {
  MadeFoot made;
  for (int s = kFirst; s <= kLast; ++s) {
    addShell(made, s, 20, 0.100, 0.120);
    for (int i = 0; i < 20; ++i) made.add((s - 0.4 + 0.04 * i) * made.step(), before, 0.010 + 0.004 * i);
  }
  return shellSeenFrom(made.foot(), fitsOf(kFirst, kLast));
}

TEST(ShellSeenFrom, ATenthOfTheReachBeforeItIsPartOfAWallAndNothingBehind) {
  EXPECT_NEAR(seenBehind(0.040), 0.018, 1e-3);
  EXPECT_NEAR(seenBehind(0.060), 0.1025, 1e-4);
  EXPECT_NEAR(seenBehind(-0.003), 0.1025, 1e-4);
}

TEST(ShellSeenFrom, TenPointsOfAStationAreTheLeast) {
  EXPECT_TRUE(std::isnan(seenFrom(0, 0.0, 9)));
  EXPECT_GT(seenFrom(0, 0.0, 11), 0.1);
}

TEST(ShellSeenFrom, WithoutStationsIsNotKnown) {
  MadeFoot made;
  made.addAll(50, -0.001, 0.001, [](double) { return 0.1; });
  EXPECT_TRUE(std::isnan(shellSeenFrom(made.foot(), std::vector<FootFit>(360))));
}

/// The share of 40 stations, at the first few of which so many points of the shell are seen below.
/// @param beside  points as low off the shell at every station
/// @param off     how far; behind it where below zero [m]
double shareAbove(int stations, int points = 1, double depth = 0.008, int beside = 0, double off = -0.030) {
  MadeFoot made;
  for (int s = 0; s < 40; ++s) {
    addShell(made, kFirst + s, 50, 0.0, 0.030);
    if (s < stations) addShell(made, kFirst + s, points, -depth, -depth);
    for (int i = 0; i < beside; ++i) made.add((kFirst + s) * made.step(), off, -0.008);
  }
  return shareAboveShell(made.foot(), fitsOf(kFirst, kFirst + 39));
}

TEST(ShareAboveShell, IsOfStationsFromThreeOnHoweverManyPointsEachHas) {
  EXPECT_EQ(shareAbove(0), 0.0);
  EXPECT_EQ(shareAbove(2, 20), 0.0);
  EXPECT_EQ(shareAbove(3), 3.0 / 40.0);
  EXPECT_EQ(shareAbove(20, 20), 0.5);
}

TEST(ShareAboveShell, LooksFromTheErrorsOfTheLevelToFourHundredthsOfTheReachBelow) {
  EXPECT_EQ(shareAbove(20, 1, 0.0022), 0.0);
  EXPECT_EQ(shareAbove(20, 1, 0.0025), 0.5);
  EXPECT_EQ(shareAbove(20, 1, 0.0220), 0.5);
  EXPECT_EQ(shareAbove(20, 1, 0.0235), 0.0);
}

// 80 points in 50 mm behind the shell: 6.4 in the 4 mm that are the shell's, and 5.1 more by chance.
TEST(ShareAboveShell, WhatStrayPointsExplainDoesNotCount) {
  const double strays = 80.0 * 4.0 / 50.0;
  EXPECT_NEAR(shareAbove(20, 1, 0.008, 2), (20.0 - strays - 2.0 * std::sqrt(strays)) / 40.0, 1e-9);
  EXPECT_EQ(shareAbove(12, 1, 0.008, 2), 0.0);
  EXPECT_EQ(shareAbove(20, 1, 0.008, 2, -0.0035), 0.5) << "the shell's own";
  EXPECT_LT(shareAbove(20, 1, 0.008, 2, -0.0045), 0.5);
}

TEST(ShareAboveShell, WhereSomethingLiesAsLowBeforeTheShellItIsNoCrownThatHidesIt) {
  EXPECT_EQ(shareAbove(20, 1, 0.008, 1, 0.0045), 0.0);
  EXPECT_EQ(shareAbove(20, 1, 0.008, 1, 0.0530), 0.0);
  EXPECT_EQ(shareAbove(20, 1, 0.008, 1, 0.0550), 0.5) << "a tenth of the reach before it";
}

TEST(ShareAboveShell, IsNotKnownWhereNothingStands) {
  MadeFoot made;
  addShell(made, kFirst, 50, -0.010, 0.030);
  EXPECT_TRUE(std::isnan(shareAboveShell(made.foot(), std::vector<FootFit>(360))));
}

}  // namespace tank_datum::shell_below_test
