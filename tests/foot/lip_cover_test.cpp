#include "foot/lip_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::lip_cover_test {

using namespace made_feet;

constexpr double kLip = 0.06, kThick = 0.012, kFar = 0.30, kBin = 0.003;

/// A lip upon a ringwall, which falls by so much.
double foot(double d, double falls = 0.0) { return d < kLip ? 0.0 : -kThick - falls * (d - kLip); }

/// Soil that is so thick at the shell and thins out evenly.
double soil(double d, double thick) { return thick * (1.0 - d / kFar); }

/// Heights about stations, from where their fits lie, against the distance from the shell.
using Section = std::function<double(int station, double d)>;

/// What may cover stations whose sections are these, those of others a bare foot; stations up to so many on either side
/// of the first have it.
LipCover coverOf(const Section& section, int points = 40, double spread = 0.0012, double seen_to = kFar) {
  MadeFoot made;
  for (int i = 0; i < 360; ++i) made.addStation(i, points, 0.013, kFar, [&](double d) { return section(i, d); });
  FootFit fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0, fit.sigma = 0.0002;
  FootPass pass;
  pass.fits.assign(360, fit);
  pass.priors.settled = true;
  FootProfile& whole = pass.sections.whole;
  whole.bin = kBin, whole.edge = kLip, whole.blur = 0.004, whole.noise = 0.001, whole.offset = 0.0;
  for (int bin = 0; bin < 100; ++bin) {
    const double d = kBin * (bin + 0.5);
    whole.height.push_back(d < seen_to ? foot(d) : kUnknown);
    whole.spread.push_back(spread);
  }
  return findLipCover(made.foot(), pass, pass.fits);
}

bool isNearFirst(int station, int near = 20) { return std::min(station, 360 - station) <= near; }

/// Stations near the first have something upon their foot, above where their fit lies; all others are a bare foot.
Section upon(const std::function<double(double)>& what) {
  return [what](int station, double d) { return isNearFirst(station) ? what(d) : foot(d); };
}

TEST(FindLipCover, IsNoneOnABareFoot) {
  const LipCover cover = coverOf(upon([](double d) { return foot(d); }));
  EXPECT_EQ(std::count(cover.covered.begin(), cover.covered.end(), true), 0);
  EXPECT_EQ(*std::max_element(cover.maybe.begin(), cover.maybe.end()), 0.0);
}

TEST(FindLipCover, IsSoilOnLipAndRingwallAlike) {
  const auto thick = [](double soil_thick) {
    return coverOf(upon([=](double d) { return foot(d) + soil(d, soil_thick) - soil(0.03, soil_thick); })).covered;
  };
  EXPECT_TRUE(thick(0.010)[0]);
  EXPECT_FALSE(thick(0.010)[180]);
  EXPECT_FALSE(thick(0.005)[0]);  // falls by 0.017 m/m
  EXPECT_TRUE(thick(0.0075)[0]);
}

TEST(FindLipCover, IsNotSoilOnTheRingwallOnly) {
  const auto section = upon([](double d) { return foot(d) + (d < kLip ? 0.0 : soil(d, 0.010)); });
  EXPECT_FALSE(coverOf(section).covered[0]);
  EXPECT_EQ(coverOf(section).maybe[0], 0.0);
}

TEST(FindLipCover, IsNotWhereAGutterLiesFartherOut) {
  const auto gutter = [](double middle) {
    return upon([=](double d) { return foot(d) - (d < 0.14 ? 0.0 : d < 0.22 ? middle : 0.010); });
  };
  EXPECT_FALSE(coverOf(gutter(0.0)).covered[0]);
  EXPECT_FALSE(coverOf(gutter(0.002)).covered[0]);
  EXPECT_TRUE(coverOf(gutter(0.003)).covered[0]);
}

TEST(FindLipCover, MayBeWhereAllBeyondTheLipIsLower) {
  const LipCover cover = coverOf(upon([](double d) { return foot(d) - (d < kLip ? 0.0 : 0.006); }));
  EXPECT_FALSE(cover.covered[0]);
  EXPECT_NEAR(cover.maybe[0], 0.006, 1e-6);
  EXPECT_EQ(cover.maybe[180], 0.0);
}

TEST(FindLipCover, IsPlainFromAThousandthOfTheReachOn) {
  const auto lower = [](double by) { return coverOf(upon([=](double d) { return foot(d) - (d < kLip ? 0.0 : by); })); };
  EXPECT_EQ(lower(0.0008).maybe[0], 0.0);
  EXPECT_GT(lower(0.0012).maybe[0], 0.0);
}

TEST(FindLipCover, IsPlainBeyondThreeTimesWhatArcsDifferBy) {
  // arcs of 20 degrees lie higher and lower by 1 mm, by 2 mm off their median: a robust standard deviation of 3 mm
  const auto uneven = [](double by) {
    return coverOf([=](int station, double d) {
      const double level = isNearFirst(station, 10) ? -by : station / 20 % 2 == 0 ? 0.001 : -0.001;
      return foot(d) + (d < kLip ? 0.0 : level);
    });
  };
  EXPECT_EQ(uneven(0.008).maybe[0], 0.0);
  EXPECT_GT(uneven(0.013).maybe[0], 0.0);
}

TEST(FindLipCover, LooksAtStationsWithinFiveDegreesTogether) {
  const auto near = [](int stations) {
    return coverOf(
        [=](int station, double d) { return foot(d) - (d >= kLip && isNearFirst(station, stations) ? 0.006 : 0.0); });
  };
  EXPECT_GT(near(3).maybe[0], 0.0);
  EXPECT_EQ(near(2).maybe[0], 0.0);
  EXPECT_GT(near(20).maybe[16], 0.0);
  EXPECT_EQ(near(20).maybe[24], 0.0);
}

/// All beyond the lip is lower near the first station.
double lowerNearFirst(int station, double d) { return foot(d) - (d >= kLip && isNearFirst(station) ? 0.006 : 0.0); }

TEST(FindLipCover, IsToldByTenPointsOfAPart) {
  EXPECT_GT(coverOf(lowerNearFirst, 3).maybe[0], 0.0);  // eleven
  const auto at_every_other = [](int station, double d) {
    return station % 2 == 0 ? lowerNearFirst(station, d) : -0.07;
  };
  EXPECT_EQ(coverOf(at_every_other, 3).maybe[0], 0.0);  // five
}

TEST(FindLipCover, IsNotToldByWhatHasNoHeightOfItsOwn) {
  EXPECT_GT(coverOf(lowerNearFirst, 40, 0.0019).maybe[0], 0.0);
  EXPECT_EQ(coverOf(lowerNearFirst, 40, 0.0021).maybe[0], 0.0);
}

TEST(FindLipCover, IsToldByTwelveBinsBeyondTheEdge) {
  EXPECT_GT(coverOf(lowerNearFirst, 40, 0.0012, 0.104).maybe[0], 0.0);
  EXPECT_EQ(coverOf(lowerNearFirst, 40, 0.0012, 0.097).maybe[0], 0.0);
}

TEST(FindLipCover, LeavesOutWhatIsFartherOffThanATenthOfTheReach) {
  const auto beyond = [](double z) { return coverOf(upon([=](double d) { return d > kLip ? z : 0.0; })).maybe[0]; };
  EXPECT_EQ(beyond(-0.07), 0.0);
  EXPECT_GT(beyond(-0.05), 0.0);
}

}  // namespace tank_datum::lip_cover_test
