#include "foot/foot_banks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::foot_banks_test {

using namespace made_feet;

constexpr int kFirst = 40, kLast = 60;

bool isInArc(int station) { return station >= kFirst && station <= kLast; }

/// A lip with a ringwall 15 mm lower, and an arc of stations that rise above the others.
struct Banked {
  double rise = 0.020;   ///< of the arc's stations [m]
  double depth = 0.010;  ///< how much lower than elsewhere the section lies below them [m]
  double from = 0.0605, to = 0.2995;
  double spread = 0.0;  ///< of the sections, as their lower quartile shows it [m]
  int every = 1;        ///< stations to one whose ringwall is seen, the arc's apart
  int missing = 0;      ///< stations that do not stand on either side of the arc
  double lip = 0.0;     ///< where the surface ends; 3 mm more are seen of it; 0: nothing [m]
  double soil = 0.0;    ///< where what lies in the arc ends, before which nothing is lower [m]
};

/// The section of a lip of so much, whose edge is blurred by as much as a fifth of a bin; 0: of a foundation.
FootProfile lipOf(double edge) {
  FootProfile profile;
  profile.surface = edge > 0.0 ? Surface::AnnularPlate : Surface::Foundation;
  profile.edge = edge, profile.blur = 0.004;
  return profile;
}

const std::vector<bool> kAll(360, true);

std::vector<bool> banksOf(const Banked& given) {
  constexpr double kQuartile = 0.6745;
  MadeFoot made;
  std::vector<double> levels;
  for (int s = 0; s < 360; ++s) {
    const bool in = isInArc(s), beside = s >= kFirst - given.missing && s <= kLast + given.missing;
    const double level = in ? given.rise : 0.0;
    levels.push_back(in || !beside ? level : kUnknown);
    const double off = kQuartile * given.spread * (s / 7 % 3 - 1);
    const auto ringwall = [&](double d) { return level - 0.015 - (!in ? off : d < given.soil ? 0.0 : given.depth); };
    if (in || s % given.every == 0) made.addStation(s, 120, given.from, given.to, ringwall);
    if (given.lip > 0.0) made.addStation(s, 120, 0.0205, given.lip + 0.003, [&](double) { return level; });
  }
  return findBanks(made.foot(), lipOf(given.lip), levels, kAll);
}

bool isBank(const Banked& given) { return banksOf(given)[(kFirst + kLast) / 2]; }

TEST(FindBanks, WhatRisesAboveItsNeighboursAsTheFoundationSinksBelowItIsABank) {
  const std::vector<bool> banks = banksOf({});
  for (int s = 0; s < 360; ++s) EXPECT_EQ(banks[static_cast<std::size_t>(s)], isInArc(s)) << s;
}

/// Whether an arc is a bank that falls from 22 mm at its first station to nothing behind its last one, where a station
/// that stands 22 mm high before it shows its ringwall so far [m].
bool isFallingBank(double shown) {
  constexpr int kBefore = kFirst - 8;
  MadeFoot made;
  std::vector<double> levels;
  for (int s = 0; s < 360; ++s) {
    const double along = static_cast<double>(s - kFirst) / (kLast + 1 - kFirst);
    const bool stands = s <= kBefore - 8 || s == kBefore || s >= kFirst, high = s >= kBefore && s <= kLast;
    const double level = !high ? 0.0 : isInArc(s) ? 0.022 * (1.0 - along) : 0.022;
    levels.push_back(stands ? level : kUnknown);
    const double ringwall = isInArc(s) ? -0.015 : level - 0.015;
    const double to = s == kBefore ? shown : 0.2995;
    if (stands && to > 0.0605) made.addStation(s, 120, 0.0605, to, [&](double) { return ringwall; });
  }
  return findBanks(made.foot(), lipOf(0.0), levels, kAll)[kFirst + 2];
}

TEST(FindBanks, AStationThatMayStandOnTheSameBankIsNoMeasureOfItsRise) {
  EXPECT_TRUE(isFallingBank(0.0));
  EXPECT_TRUE(isFallingBank(0.1995));  // where soil may go on to
  EXPECT_FALSE(isFallingBank(0.2995));
}

TEST(FindBanks, WhatLiesOnAFoundationIsToldByWhatIsSeenBeyond) {
  Banked given{0.020, 0.006};
  given.soil = 0.2405;  // three of twelve bins are lower
  EXPECT_TRUE(isBank(given));
  given.soil = 0.2805;  // one
  EXPECT_FALSE(isBank(given));
}

/// Whether soil over an arc is a bank, beyond which a station shows so few points; others, from three stations on, show
/// all of the ringwall.
bool isSparseBank(int points) {
  constexpr double kFrom = 0.1, kSoil = 0.24, kTo = 0.4995;
  MadeFoot made;
  std::vector<double> levels;
  for (int s = 0; s < 360; ++s) {
    const bool in = isInArc(s), beside = isInArc(s - 3) || isInArc(s + 3);
    levels.push_back(in ? 0.020 : beside ? kUnknown : 0.0);
    made.addStation(s, 120, kFrom, in ? kSoil : kTo, [&](double) { return in ? 0.005 : -0.015; });
    for (int i = 0; in && i < points; ++i)
      made.add(s * made.step(), kSoil + (kTo - kSoil) * std::fmod(0.618034 * (points * s + i), 1.0), -0.005);
  }
  return findBanks(made.foot(), lipOf(0.0), levels, kAll)[(kFirst + kLast) / 2];
}

TEST(FindBanks, AStationThatShowsFewBinsIsLookedAtInWiderOnes) {
  EXPECT_TRUE(isSparseBank(2));  // the soil fills a third of 25 bins, and beyond are one or two points in each
  EXPECT_FALSE(isSparseBank(0));
}

TEST(FindBanks, AnArcOverTheFirstAzimuthIsOneArc) {
  MadeFoot made;
  std::vector<double> levels;
  for (int s = 0; s < 360; ++s) {
    const bool in = s < 10 || s >= 350;
    levels.push_back(in ? 0.02 : 0.0);
    made.addStation(s, 120, 0.0605, 0.2995, [&](double) { return in ? -0.005 : -0.015; });
  }
  const std::vector<bool> banks = findBanks(made.foot(), lipOf(0.0), levels, kAll);
  EXPECT_EQ(std::count(banks.begin(), banks.end(), true), 20);
  EXPECT_TRUE(banks[0] && banks[9] && banks[350]);
}

TEST(FindBanks, APlateOnAFoundationThatIsLowerInASectorStands) {
  EXPECT_FALSE(isBank({0.0, 0.010}));
  EXPECT_FALSE(isBank({0.004, 0.010}));  // rises by less than half of it
  EXPECT_TRUE(isBank({0.006, 0.010}));
}

TEST(FindBanks, AFoundationThatRisesWithItsStationsIsADatum) { EXPECT_FALSE(isBank({0.020, 0.0})); }

TEST(FindBanks, EightThousandthsOfTheReachAreTheLeast) {
  EXPECT_FALSE(isBank({0.020, 0.0035}));
  EXPECT_TRUE(isBank({0.020, 0.0055}));
}

TEST(FindBanks, ThreeTimesWhatSectionsUsuallyScatterByStands) {
  Banked given;  // 3 times the root of 1 and 4 is 6.7 mm
  given.spread = 0.002;
  given.depth = 0.0064;
  EXPECT_FALSE(isBank(given));
  given.depth = 0.0072;
  EXPECT_TRUE(isBank(given));
}

TEST(FindBanks, AQuarterOfTheSectionsSaysWhatIsUsual) {
  Banked given;
  given.every = 40;  // one is part of seven sections
  EXPECT_FALSE(isBank(given));
  given.every = 24;
  EXPECT_TRUE(isBank(given));
}

/// Whether an arc is a bank where every so many stations show the ringwall, each in a row 3 mm wide that lies elsewhere
/// at the next one.
/// @param dense  stations from the first on that are 20 mm high and show all of the ringwall
bool isBankInRows(int every, double from, double to, int dense = 0) {
  MadeFoot made;
  std::vector<double> levels;
  for (int s = 0; s < 360; ++s) {
    const double level = isInArc(s) || s < dense ? 0.020 : 0.0,
                 d = from + (to - from) * std::fmod(0.618034 * (s / every), 1.0);
    levels.push_back(level);
    if (s < dense) made.addStation(s, 120, from, to, [](double) { return -0.015; });
    if (s % every == 0) made.addStation(s, 12, d, d + 0.003, [](double) { return -0.015; });
  }
  return findBanks(made.foot(), lipOf(0.0), levels, kAll)[(kFirst + kLast) / 2];
}

TEST(FindBanks, BinsAreAsWideAsRowsLieApart) {
  EXPECT_TRUE(isBankInRows(2, 0.1, 0.49));
  EXPECT_FALSE(isBankInRows(10, 0.1, 0.49));  // half of the sections do not show most of six bins
}

TEST(FindBanks, ADenselySeenBankDoesNotSayAloneWhatIsUsual) { EXPECT_TRUE(isBankInRows(3, 0.1, 0.49, 80)); }

TEST(FindBanks, BinsAreTwelveOrSixWhereRowsLieFarApart) {
  EXPECT_TRUE(isBankInRows(7, 0.170, 0.245, 84));  // two of twelve, one of six
  EXPECT_TRUE(isBankInRows(3, 0.1, 0.325));        // three of six, one of three
}

/// Whether soil, 30 mm high over so many stations, is a bank where all stations say what is usual, or but those on it,
/// and so many others have a ringwall that stands 20 mm higher.
bool isWideBank(int stations, bool stood = true, int higher = 0) {
  MadeFoot made;
  std::vector<double> levels(360, 0.0);
  std::vector<bool> say(360, true);
  std::fill_n(levels.begin(), stations, 0.030), std::fill_n(say.begin(), stations, stood);
  for (int s = 0; s < 360; ++s)
    made.addStation(s, 120, 0.0605, 0.2995, [&](double) { return s < 360 - higher ? -0.015 : 0.005; });
  return findBanks(made.foot(), lipOf(0.0), levels, say)[static_cast<std::size_t>(stations / 2)];
}

TEST(FindBanks, SoilOverAThirdOfTheRingDoesNotSayHowMuchIsUsual) {
  EXPECT_TRUE(isWideBank(120) && isWideBank(60, true, 120));
}

TEST(FindBanks, WhatIsUsualIsSaidByTheStationsThatStoodBefore) {
  EXPECT_FALSE(isWideBank(200));
  EXPECT_TRUE(isWideBank(200, false));
}

TEST(FindBanks, TwoBinsFromTwelveHundredthsOfTheReachOnAreLookedAt) {
  EXPECT_TRUE(isBank({0.020, 0.010, 0.0605, 0.0995}));
  EXPECT_FALSE(isBank({0.020, 0.010, 0.0605, 0.0795}));
  EXPECT_FALSE(isBank({0.020, 0.010, 0.0205, 0.0595}));
  EXPECT_FALSE(isBank({0.020, 0.010, 0.0405, 0.0795}));
}

TEST(FindBanks, ALipAndItsBlurSayNothingOfWhatLiesBeyond) {
  Banked given{0.020, 0.018, 0.0805, 0.2995, 0.005};  // well below the ringwall, whose scatter is known
  EXPECT_TRUE(isBank(given));
  given.lip = 0.0785;  // in the bin of 60 to 80 mm, the blur in the next one
  given.from = 0.1005;
  EXPECT_TRUE(isBank(given));
}

TEST(FindBanks, NeighboursAreLookedForWithinTenDegrees) {
  Banked sector{0.0, 0.010};
  sector.missing = 8;
  EXPECT_FALSE(isBank(sector));
  sector.missing = 12;  // nobody can tell
  EXPECT_TRUE(isBank(sector));
}

}  // namespace tank_datum::foot_banks_test
