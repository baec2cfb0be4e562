#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_feet.h"

namespace tank_datum {
namespace {

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

TEST(FirstElevations, AStationWithFiftyPointsTakesItsOwnElevationOneWithFewerThatOfTheLine) {
  for (const int count : {55, 45}) {
    MadeFoot made;
    made.addAll(count, 0.014, 0.3, falling);
    // the line through the falling surface meets the shell at 0; the nearest points lie 38 mm out
    EXPECT_NEAR(firstLook(made)[10], count > 50 ? falling(0.038) : 0.0, 0.0006) << count;
  }
}

/// The elevation of stations with so many points 30 mm from the shell, raised by so much, and sixty far out.
double nearest(int count, double raised, const FootScales& scales = kScales) {
  MadeFoot made;
  made.addAll(60, 0.2, 0.3, falling);
  made.addAll(count, 0.0299, 0.0301, [raised](double d) { return falling(d) + raised; });
  return firstLook(made, scales)[10];
}

TEST(FirstElevations, AStationsElevationIsThatOfItsFiveNearestPointsOrMore) {
  EXPECT_NEAR(nearest(5, 0.0), falling(0.03), 0.0002);
  EXPECT_LT(nearest(4, 0.0), falling(0.18));
}

TEST(FirstElevations, PointsAHundredthOfTheReachTimesSixOffTheStretchAreAnotherThing) {
  EXPECT_NEAR(nearest(12, 0.026), falling(0.03) + 0.026, 0.0005);
  EXPECT_LT(nearest(12, 0.036), falling(0.18));
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
      made.addStation(s, 40, 0.014, 0.3, [z](double) { return z; });
    }
    const std::vector<double> datum = firstLook(made);
    for (const std::size_t i : {100U, 200U}) EXPECT_EQ(datum[i] == datum[i + 1], stations == 720) << i;
  }
}

}  // namespace
}  // namespace tank_datum
