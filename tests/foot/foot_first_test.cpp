#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::foot_first_test {

using namespace made_feet;

double level(double) { return 0.0; }
double falling(double d) { return -0.05 * d; }

std::vector<double> firstLook(MadeFoot& made, const FootScales& scales = kScales) {
  return firstElevations(made.foot(scales), tankOfFoot()).known;
}

TEST(FirstElevations, AScanWhoseNoiseIsAHundredthOfTheSectionTellsItsSurfacesApart) {
  MadeFoot made;
  EXPECT_TRUE(isResolved(made.foot({0.3, 0.0048, 0.013})));
  EXPECT_FALSE(isResolved(made.foot({0.3, 0.0052, 0.013})));
}

TEST(FirstElevations, OneStationIsSeenFromFiveDegreesAndBelievedThreeFurther) {
  MadeFoot made;
  made.addStation(100, 400, 0.014, 0.3, level);
  const FootElevations first = firstElevations(made.foot(), tankOfFoot());
  const std::vector<double>& datum = first.known;
  EXPECT_EQ(std::count_if(datum.begin(), datum.end(), [](double z) { return std::isfinite(z); }), 11);
  EXPECT_EQ(std::count(first.seen.begin(), first.seen.end(), true), 17);
  EXPECT_TRUE(first.seen[92] && first.seen[108]);
}

/// Whether one station, on which these cells of 6 mm hold so many points each, 0.1 m above all others, looks for
/// itself: its stretch is then no part of the ring's. Else it takes what its neighbours see.
bool looksForItself(int cells, int count) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s != 100) made.addStation(s, 400, 0.014, 0.3, [](double) { return -0.1; });
  }
  for (int cell = 0; cell < cells; ++cell) {
    made.addStation(100, count, 0.013 + 0.006 * cell + 0.001, 0.013 + 0.006 * cell + 0.005, level);
  }
  return std::isnan(firstLook(made)[100]);
}

TEST(FirstElevations, AStationLooksForItselfWhereSevenCellsOfTenHoldTenPoints) {
  EXPECT_TRUE(looksForItself(7, 10));
  EXPECT_FALSE(looksForItself(6, 10));
  EXPECT_FALSE(looksForItself(7, 9));
}

/// What is found at station 10 where the stations up to two from it have so many points on a step this high, and all
/// others twenty below it: windows of some degrees see both.
double onAStep(int count, double high) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const bool raised = s >= 8 && s <= 12;
    made.addStation(s, raised ? count : 20, 0.014, 0.3, [&](double) { return raised ? high : 0.0; });
  }
  return firstLook(made)[10];
}

TEST(FirstElevations, AStationTakesTheElevationOfItsOwnFivePointsOnTheStretch) {
  EXPECT_NEAR(onAStep(5, 0.004), 0.004, 1e-6);
  EXPECT_LT(onAStep(4, 0.004), 0.003);
}

TEST(FirstElevations, PointsAFiftiethOfTheReachOffTheStretchAreAnotherThing) {
  EXPECT_NEAR(onAStep(5, 0.009), 0.009, 1e-6);
  EXPECT_LT(onAStep(5, 0.012), 0.011);
}

/// What is found in a part of the ring, sixty stations wide, that lies so much lower, with slopes of twenty stations
/// beside it, where four rows of points show it.
std::vector<double> intoASettledPart(double deep, bool inside) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const int away = std::max(0, std::abs(s - 180) - 30);
    const double z = away >= 20 ? 0.0 : -deep * 0.5 * (1.0 + std::cos(away * kTwoPi / 40.0));
    for (int k = 0; k < 12; ++k) {
      const double rough = 0.0005 * std::sin(1.0 + 7.0 * k + 3.0 * s);
      made.add((s + 0.3 * (k % 3 - 1)) * made.step(), 0.03 + 0.07 * (k / 3), z + rough);
    }
  }
  Foot& foot = made.foot();
  foot.inside = inside;
  return firstElevations(foot, tankOfFoot()).known;
}

TEST(FirstElevations, AFloorIsFollowedIntoAPartThatSettled) {
  const std::vector<double> inside = intoASettledPart(0.06, true);
  EXPECT_NEAR(inside[180], -0.06, 0.0005);
  EXPECT_NEAR(inside[140], -0.03, 0.003) << "half way down";
  EXPECT_NEAR(inside[10], 0.0, 0.0005);
  EXPECT_TRUE(std::isnan(intoASettledPart(0.06, false)[180])) << "soil goes up so outside";
}

TEST(FirstElevations, TheTiltOfTheTankDoesNotBlurTheWindowsOfSparseStations) {
  MadeFoot made;
  const auto tilted = [](int s) { return 0.04 * std::cos(s * kTwoPi / 360.0); };
  for (int s = 0; s < 360; ++s) {
    made.addStation(s, 4, 0.014, 0.06, [&](double) { return tilted(s); });
    made.addStation(s, 12, 0.07, 0.3, [&](double) { return tilted(s) - 0.006; });
  }
  Tank tank = tankOfFoot();
  tank.foot.coefficients = Eigen::Vector3d(0.0, 0.04, 0.0);
  const std::vector<double> known = firstElevations(made.foot(), tank).known;
  for (const int s : {45, 90, 135}) EXPECT_NEAR(known[static_cast<std::size_t>(s)], tilted(s), 0.001) << s;
}

/// What is first known of a dip 12 mm deep in its middle, where a station has so many points on the pad and the shell
/// is seen to so far below its neighbours' level.
double inADip(int count, double shell_down_to, double half_width = 6.0) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double off = std::abs(s - 100) / half_width;
    const double z = off < 1.0 ? -0.012 * std::pow(std::cos(0.5 * kPi * off), 2.0) : 0.0;
    made.addStation(s, count, 0.014, 0.3, [z](double) { return z; });
    for (double up = std::max(z, -shell_down_to); up < 0.03; up += 0.001) made.add(s * made.step(), 0.0, up);
  }
  return firstLook(made)[100];
}

TEST(FirstElevations, ADipIsTakenFromAStationsOwnPointsWhereTheShellIsSeenToGoDownToIt) {
  EXPECT_LT(inADip(6, 0.012), -0.008);
  EXPECT_FALSE(inADip(6, 0.0) < -0.004) << "what lies below may be the ground under a plate that is not seen";
  EXPECT_FALSE(inADip(4, 0.012) < -0.004) << "five points show a surface";
}

/// The elevation of stations with so many points 30 mm from the shell, raised by so much, and sixty far out.
double nearest(int count, double raised, const FootScales& scales = kScales) {
  MadeFoot made;
  made.addAll(60, 0.2, 0.3, falling);
  made.addAll(count, 0.0299, 0.0301, [raised](double d) { return falling(d) + raised; });
  return firstLook(made, scales)[10];
}

TEST(FirstElevations, WhereNoiseHidesTheSurfacesTheFiveNearestPointsTellTheElevation) {
  const FootScales noisy{0.3, 0.008, 0.013};
  EXPECT_NEAR(nearest(5, 0.1, noisy), falling(0.03) + 0.1, 0.0005);
  EXPECT_LT(nearest(4, 0.1, noisy), falling(0.18));
}

TEST(FirstElevations, MoreThanThreeHundredAndSixtyStationsShareTheirStretches) {
  for (const int stations : {360, 720}) {
    MadeFoot made(stations);
    for (int s = 0; s < stations; ++s) {
      const double z = 0.05 * std::cos(s * made.step());
      made.addStation(s, 4, 0.014, 0.3, [z](double) { return z; });
    }
    const std::vector<double> datum = firstLook(made);
    for (const std::size_t i : {100U, 200U}) EXPECT_EQ(datum[i] == datum[i + 1], stations == 720) << i;
  }
}

}  // namespace tank_datum::foot_first_test
