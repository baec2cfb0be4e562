#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_outliers_test {

using namespace made_feet;

/// Whether a station stood that lay on something else, where so many did and so many more were hidden.
bool stoodAmong(int other, int hidden) {
  FootElevations elevations;
  elevations.known.assign(360, 0.0);
  FootOutliers before;
  before.reasons.assign(360, Unmeasured::None);
  std::fill_n(before.reasons.begin(), other, Unmeasured::OtherSurface);
  std::fill_n(before.reasons.begin() + other, hidden, Unmeasured::Hidden);
  EXPECT_EQ(stoodBefore(elevations, before).size(), 360u);
  return stoodBefore(elevations, before)[0];
}

TEST(StoodBefore, AreNotThoseOnSomethingElseUnlessTheseAreMore) {
  EXPECT_FALSE(stoodAmong(100, 100));
  EXPECT_TRUE(stoodAmong(140, 100));
  const FootOutliers none;
  FootElevations elevations;
  elevations.known = {0.0, kUnknown};
  EXPECT_EQ(stoodBefore(elevations, none), (std::vector<bool>{true, false}));
}

Unmeasured reasonAt50(const Foot& foot, const FootPass& pass) { return findOutliers(foot, pass).reasons[50]; }

/// Whether a station on a level pad is dropped beside which the shell is seen by so many points a centimetre below the
/// pad, and by so many up to two above it.
bool isDropped(int below, int above) {
  MadeFoot made;
  made.addAll(40, 0.02, 0.28, [](double) { return 0.0; });
  for (int i = 0; i < below; ++i) made.add((50 - 0.2 + 0.4 * i / below) * made.step(), 0.0, -0.010);
  for (int i = 0; i < above; ++i) made.add((50 - 0.2 + 0.4 * i / above) * made.step(), 0.0, 0.004 + 0.014 * i / above);
  Foot& foot = made.foot();
  return reasonAt50(foot, levelPass(foot.half_step, 0.3)) != Unmeasured::None;
}

TEST(FindOutliers, AShellSeenBelowAQuarterAsOftenAsAboveGoesOn) {
  EXPECT_FALSE(isDropped(8, 40));
  EXPECT_TRUE(isDropped(13, 40));
}

TEST(FindOutliers, ThreePointsBelowAreStrayHoweverFewAreAbove) {
  EXPECT_FALSE(isDropped(3, 8));
  EXPECT_TRUE(isDropped(4, 8));
}

/// Why a station does not stand whose own stretch has points only so far above the surface that was fitted to its
/// neighbours' points.
Unmeasured reasonOfPointsAbove(double height) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) made.addStation(s, 40, 0.02, 0.28, [&](double) { return s == 50 ? height : 0.0; });
  Foot& foot = made.foot();
  return reasonAt50(foot, levelPass(4.0 * foot.half_step, 0.3));
}

TEST(FindOutliers, PointsFourNoisesOffTheSurfaceAreNoSupport) {
  EXPECT_EQ(reasonOfPointsAbove(0.0012), Unmeasured::None);
  EXPECT_EQ(reasonOfPointsAbove(0.0020), Unmeasured::Hidden);
}

/// Why a station does not stand that lies with its neighbours on points that slope, on a ring of level lips.
/// @param seen  slope of lips as the scan shows them all
Unmeasured reasonOfSlope(double slope, double seen = 0.0, double sigma_seen = 0.0) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const bool heap = s >= 49 && s <= 51;
    made.addStation(s, 40, 0.0155, 0.0595, [&](double d) { return heap ? slope * (d - 0.0375) : 0.0; });
  }
  Foot& foot = made.foot();
  FootPass pass = levelPass(foot.half_step, 0.06);
  pass.priors.settled = true, pass.priors.seen = seen, pass.priors.sigma_seen = sigma_seen;
  return reasonAt50(foot, pass);
}

/// The least slope at which no station stands whose points all slope, so rough that none tells by itself.
double leastSlopeOfHeaps(double noise) {
  double stand = 0.0, fall = -0.6;
  for (int halving = 0; halving < 12; ++halving) {
    const double slope = 0.5 * (stand + fall);
    MadeFoot made;
    for (int s = 0; s < 360; ++s) {
      for (int i = 0; i < 12; ++i) {
        const double d = 0.0155 + 0.044 * (i + 0.5) / 12.0, off = i % 4 == 0 || i % 4 == 3 ? noise : -noise;
        made.add((s + 0.01 * i - 0.055) * made.step(), d, slope * (d - 0.0375) + off);
      }
    }
    Foot& foot = made.foot();
    FootPass pass = levelPass(foot.half_step, 0.06);
    pass.priors.settled = true, pass.sections.whole.noise = noise;
    for (FootFit& fit : pass.fits) fit.noise = noise;
    (reasonAt50(foot, pass) == Unmeasured::None ? stand : fall) = slope;
  }
  return fall;
}

TEST(FindOutliers, HeapsOfWhichNoneTellsAreToldTogether) {
  // 36 points of a station and its neighbours tell a slope to 0.237, each of them three times; theirs lean by 0.026
  const double sigma = 1.2533 * 0.237 * std::sqrt(3.0 / 360.0);
  EXPECT_NEAR(leastSlopeOfHeaps(0.010), -0.1 - 3.0 * sigma + 0.026, 0.01);
}

TEST(FindOutliers, WhatRisesToTheShellByOneInTenIsAHeap) {
  EXPECT_EQ(reasonOfSlope(-0.11), Unmeasured::OtherSurface);
  EXPECT_EQ(reasonOfSlope(-0.09), Unmeasured::None);
  EXPECT_EQ(reasonOfSlope(-0.11, -0.03), Unmeasured::None);  // as the scan shows them all
  EXPECT_EQ(reasonOfSlope(0.15), Unmeasured::None);          // few rows
}

TEST(FindOutliers, NoFoundationRisesOutwardsByATwentiethAllRoundNorFallsByThreeTimesThat) {
  const auto stands = [](double seen) { return reasonOfSlope(0.0, seen) == Unmeasured::None; };
  EXPECT_TRUE(stands(0.045));
  EXPECT_FALSE(stands(0.055));
  EXPECT_TRUE(stands(-0.14));
  EXPECT_FALSE(stands(-0.16));
}

TEST(FindOutliers, WhatRisesAllRoundDoesSoBeyondThreeStandardErrorsOfASlopeThatIsKnown) {
  const auto stands = [](double seen, double sigma) { return reasonOfSlope(0.0, seen, sigma) == Unmeasured::None; };
  EXPECT_TRUE(stands(0.064, 0.005));
  EXPECT_FALSE(stands(0.066, 0.005));
  EXPECT_TRUE(stands(0.055, 0.045));
  EXPECT_FALSE(stands(0.055, 0.055));
}

/// Why a station does not stand on what rises away from the shell by so much, all round.
/// @param shell  the station's points on half a metre of it: beams are as steep as it has fewer than the surface
Unmeasured reasonOfRise(double slope, bool inside, int shell) {
  MadeFoot made;
  made.addAll(160, 0.02, 0.48, [&](double d) { return slope * d; });
  made.addStation(50, shell, -1e-4, 1e-4, [](double d) { return 0.25 + 2300.0 * d; });
  Foot& foot = made.foot();
  foot.inside = inside;
  FootPass pass = levelPass(foot.half_step, 0.3);
  for (FootFit& fit : pass.fits) fit.slope = slope;
  pass.priors.slope.assign(360, slope), pass.priors.seen = slope;
  return reasonAt50(foot, pass);
}

TEST(FindOutliers, AFloorMayRiseAwayFromTheShellAsNoFoundationOutsideDoes) {
  for (const bool inside : {false, true}) {
    const Unmeasured expected = inside ? Unmeasured::None : Unmeasured::OtherSurface;
    EXPECT_EQ(reasonOfRise(0.08, inside, 80), expected);
    EXPECT_EQ(reasonOfRise(0.04, inside, 1160), expected) << "beams of 0.14 would graze it";
    EXPECT_EQ(reasonOfRise(0.04, inside, 80), Unmeasured::None) << "beams are steep";
    EXPECT_EQ(reasonOfRise(0.2, inside, 80), Unmeasured::OtherSurface) << "a bank";
  }
}

TEST(FindOutliers, WhatRisesToTheShellMoreThanWideSurfacesAreKnownToIsAHeap) {
  const auto reason = [](double slope) {
    MadeFoot made;
    for (int s = 0; s < 360; ++s) {
      const bool heap = s >= 49 && s <= 51;
      made.addStation(s, 40, 0.02, 0.28, [&](double d) { return heap ? slope * (d - 0.15) : 0.0; });
    }
    FootPass pass = levelPass(made.foot().half_step, 0.3);
    pass.priors.sigma_slope.assign(360, 0.0005);
    return reasonAt50(made.foot(), pass);
  };
  EXPECT_EQ(reason(-0.015), Unmeasured::OtherSurface);
  EXPECT_EQ(reason(-0.008), Unmeasured::None);
  EXPECT_EQ(reason(0.015), Unmeasured::None);
}

/// Why a station does not stand that lies on points that slope, so many with it, so many stations away from all others
/// of a level pad.
Unmeasured reasonOfIsland(double slope, int gap, int stations = 3) {
  const int first = 50 - stations / 2, last = first + stations - 1;
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const bool island = s >= first && s <= last;
    if (island || s < first - gap || s > last + gap)
      made.addStation(s, 40, 0.02, 0.28, [&](double d) { return island ? slope * (d - 0.15) : 0.0; });
  }
  Foot& foot = made.foot();
  FootPass pass = levelPass(foot.half_step, 0.3);
  pass.priors.sigma_slope.assign(360, 0.003);
  return reasonAt50(foot, pass);
}

TEST(FindOutliers, AFewStationsFarFromAllOthersAreNoFoundationWhereTheirSlopeIsNot) {
  // a slope that differs by 0.003 from station to station is told to 0.004 by three, each point thrice
  EXPECT_EQ(reasonOfIsland(0.0435, 11), Unmeasured::OtherSurface);
  EXPECT_EQ(reasonOfIsland(0.0395, 11), Unmeasured::None);
  EXPECT_EQ(reasonOfIsland(0.0435, 9), Unmeasured::None);
  EXPECT_EQ(reasonOfIsland(0.0435, 11, 12), Unmeasured::None);
}

TEST(FindOutliers, WhatFallsFromTheShellByMoreThanThreeInTwentyIsNoFoundation) {
  const auto reason = [](double slope) {
    MadeFoot made;
    made.addAll(40, 0.02, 0.28, [&](double d) { return slope * d; });
    FootPass pass = levelPass(made.foot().half_step, 0.3);
    pass.sections.whole.slope = slope, pass.priors.slope.assign(360, slope);
    for (FootFit& fit : pass.fits) fit.slope = slope, fit.sigma_slope = 0.0001;
    return reasonAt50(made.foot(), pass);
  };
  EXPECT_EQ(reasonOfSlope(0.0, -0.145), Unmeasured::None);
  EXPECT_EQ(reasonOfSlope(0.0, -0.155), Unmeasured::OtherSurface);  // told of the ring, and not believed of a lip
  EXPECT_EQ(reason(-0.145), Unmeasured::None);
  EXPECT_EQ(reason(-0.155), Unmeasured::OtherSurface);
}

/// How many of a hundred elevations are kept where so many stations lie on something else and so many show nothing.
int keptOf(std::size_t other, std::size_t hidden, bool narrow = true) {
  FootOutliers outliers;
  outliers.reasons.assign(100, Unmeasured::None);
  for (std::size_t i = 0; i < other; ++i) outliers.reasons[i] = Unmeasured::OtherSurface;
  for (std::size_t i = 0; i < hidden; ++i) outliers.reasons[99 - i] = Unmeasured::Hidden;
  const std::vector<double> kept = withoutOutliers(std::vector<double>(100, 0.0), outliers, narrow);
  return static_cast<int>(std::count_if(kept.begin(), kept.end(), [](double z) { return std::isfinite(z); }));
}

TEST(WithoutOutliers, OutliersAreLeftOutUnlessTheyAreMostOfAll) {
  EXPECT_EQ(keptOf(40, 0), 60);
  EXPECT_EQ(keptOf(60, 0), 100);
  EXPECT_EQ(keptOf(0, 40), 60);
}

TEST(WithoutOutliers, StationsThatShowNothingSayNothingForThoseOnSomethingElse) {
  EXPECT_EQ(keptOf(20, 50), 30);
  EXPECT_EQ(keptOf(30, 50), 100);
  EXPECT_EQ(keptOf(20, 50, false), 100) << "on a wide surface";
}

TEST(WithoutOutliers, WhereNoneLiesOnSomethingElseThoseThatShowNothingAreKept) {
  EXPECT_EQ(keptOf(0, 70), 100);
  EXPECT_EQ(keptOf(1, 70), 29);
}

TEST(WithoutOutliers, ElevationsThatAreNotKnownDoNotCount) {
  std::vector<double> elevations(10, kUnknown);
  elevations[0] = elevations[1] = elevations[2] = 0.0;
  FootOutliers outliers;
  outliers.reasons.assign(10, Unmeasured::None);
  outliers.reasons[1] = outliers.reasons[2] = Unmeasured::OtherSurface;
  EXPECT_TRUE(std::isfinite(withoutOutliers(elevations, outliers, true)[1]));
}

}  // namespace tank_datum::foot_outliers_test
