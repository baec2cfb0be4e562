#include "foot/foot_heaps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_feet.h"

namespace tank_datum::foot_heaps_test {

using namespace made_feet;

FootFit fitOf(double slope, double sigma_slope) {
  FootFit fit;
  fit.z = 0.0, fit.sigma = 0.0005;
  fit.slope = slope, fit.sigma_slope = sigma_slope;
  return fit;
}

/// What is known of a lip that is level all round.
FootPriors levelLip() {
  FootPriors priors;
  priors.slope.assign(360, 0.0);
  priors.settled = true;
  return priors;
}

/// How many stations are found that lean by a slope, of so many beside each other.
std::ptrdiff_t heaped(int stations, double slope, double sigma_slope, const FootPriors& priors = levelLip()) {
  MadeFoot made;
  std::vector<FootFit> own(360);
  std::fill_n(own.begin() + 50, stations, fitOf(slope, sigma_slope));
  const std::vector<bool> found = findHeapedArcs(made.foot(), priors, own);
  return std::count(found.begin(), found.end(), true);
}

TEST(FindHeapedArcs, AreSteeperThanALipByTwoHundredths) {
  EXPECT_EQ(heaped(11, -0.017, 0.0001), 0);
  EXPECT_EQ(heaped(11, -0.023, 0.0001), 11);
  EXPECT_EQ(heaped(11, 0.2, 0.0001), 0);
}

TEST(FindHeapedArcs, AreSoByThreeStandardErrors) {
  EXPECT_EQ(heaped(1, -0.075, 0.01), 0);  // one and a quarter, for a median, times the root of three that share points
  EXPECT_EQ(heaped(1, -0.095, 0.01), 1);
}

TEST(FindHeapedArcs, StationsWithinFiveDegreesAreLookedAtTogether) {
  EXPECT_GT(heaped(11, -0.065, 0.02), 0);
  EXPECT_EQ(heaped(21, -0.052, 0.02), 0);
}

TEST(FindHeapedArcs, MostOfTheStationsHaveToBe) {
  MadeFoot made;
  std::vector<FootFit> own(360, fitOf(0.0, 0.002));
  std::fill_n(own.begin() + 50, 20, fitOf(-0.1, 0.002));
  const std::vector<bool> found = findHeapedArcs(made.foot(), levelLip(), own);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], i >= 50 && i < 70) << i;
}

TEST(FindHeapedArcs, AreComparedWithTheLipsOwnSlope) {
  FootPriors leaning = levelLip();
  leaning.slope.assign(360, -0.05);
  EXPECT_EQ(heaped(11, -0.06, 0.0001, leaning), 0);
  leaning.slope.assign(360, 0.0), leaning.seen = -0.05;
  EXPECT_EQ(heaped(11, -0.06, 0.0001, leaning), 0);
  EXPECT_EQ(heaped(11, -0.08, 0.0001, leaning), 11);
}

TEST(FindHeapedArcs, AreComparedWithWhatWideBeamsFeign) {
  FootPriors blended = levelLip();
  blended.blends.slope.assign(360, -0.05);
  EXPECT_EQ(heaped(11, -0.06, 0.0001, blended), 0);
  EXPECT_EQ(heaped(11, -0.08, 0.0001, blended), 11);
}

TEST(FindHeapedArcs, AreNotOfWideSurfaces) {
  FootPriors wide = levelLip();
  wide.settled = false;
  EXPECT_EQ(heaped(11, -0.1, 0.0001, wide), 0);
}

/// How many stations after a heap at the 50th go on with it, of those whose slope and scatter are told so, from some
/// station on; those before it tell.
struct GoingOn {
  double sigma_slope = 0.1, scatter = 0.001;
  int first = 51, last = 70;
  bool settled = false;

  std::ptrdiff_t count() const {
    MadeFoot made;
    FootPriors wide = levelLip();
    wide.settled = settled, wide.scatter = 0.001;
    std::vector<FootFit> own(360);
    std::vector<bool> heaps(360, false);
    heaps[50] = true;
    const auto put = [&](int from, int to, double sigma, double off) {
      for (int i = from; i <= to; ++i) {
        FootFit& fit = own[static_cast<std::size_t>(i)] = fitOf(0.0, sigma);
        fit.own = off;
      }
    };
    put(40, 49, 0.001, 0.001);
    put(first, last, sigma_slope, scatter);
    put(last + 1, last + 10, 0.001, 0.001);
    put(last + 11, 350, 0.1, 0.001);
    const std::vector<bool> found = findHeapsGoingOn(made.foot(), wide, own, heaps);
    return std::count(found.begin(), found.end(), true);
  }
};

TEST(FindHeapsGoingOn, AreStationsThatTellNoSlope) {
  EXPECT_EQ(GoingOn{}.count(), 20);  // and none beyond those that tell
  EXPECT_EQ((GoingOn{0.028}.count()), 0);
  EXPECT_EQ((GoingOn{0.032}.count()), 20);
}

TEST(FindHeapsGoingOn, AreRowsThatScatterByHalfOfWhatTheSurfaceDoes) {
  EXPECT_EQ((GoingOn{0.001, 0.00055}.count()), 0);
  EXPECT_EQ((GoingOn{0.001, 0.00045}.count()), 20);
}

TEST(FindHeapsGoingOn, AreWithinTwentyDegreesOfTheHeapOrOneAnother) {
  EXPECT_EQ((GoingOn{0.1, 0.001, 70}.count()), 1);
  EXPECT_EQ((GoingOn{0.1, 0.001, 71, 80}.count()), 0);
  EXPECT_EQ((GoingOn{0.1, 0.001, 69, 90}.count()), 22);
}

TEST(FindHeapsGoingOn, AreNoMoreThanASixthOfTheRing) { EXPECT_EQ((GoingOn{0.1, 0.001, 51, 150}.count()), 60); }

TEST(FindHeapsGoingOn, AreNotUponLips) {
  GoingOn lip;
  lip.settled = true;
  EXPECT_EQ(lip.count(), 0);
}

/// A bank against the shell, and the surface at its foot.
struct Bank {
  double slope = -0.3;    ///< of its side [m/m]
  double end = 0.2;       ///< where it meets the surface, from the shell [m]
  double seen_to = 0.28;  ///< of the surface
  double scatter = 0.0;   ///< of what lies on it
  double over = 0.0;      ///< how high it stands on what is its foot [m]
  double middle = 0.24;   ///< of the points that the station was fitted to
  double blur = 0.004;    ///< of what lies on the surface [m]
};

bool isBankBefore(const Bank& bank) {
  MadeFoot made;
  int count = 0;
  made.addStation(0, 40, 0.02, bank.end, [&](double d) {
    return bank.over + bank.slope * (d - bank.end) + (++count % 2 == 0 ? bank.scatter : -bank.scatter);
  });
  made.addStation(0, 20, bank.end, bank.seen_to, [](double) { return 0.0; });
  FootPass pass;
  FootFit fit = fitOf(0.0, 0.01);
  fit.middle = bank.middle;
  pass.fits.assign(360, fit);
  pass.sections.whole.noise = 0.0005, pass.sections.whole.blur = bank.blur;
  return isHeapBefore(made.foot(), 0, pass);
}

TEST(IsHeapBefore, IsALineThatFallsToTheSurface) {
  EXPECT_TRUE(isBankBefore({}));
  EXPECT_TRUE(isBankBefore({-0.2}));
  EXPECT_FALSE(isBankBefore({-0.12, 0.2, 0.28, 0.0, 0.0, 0.2}));
  EXPECT_FALSE(isBankBefore({0.0}));
}

TEST(IsHeapBefore, IsNoPipeNorBoxBeforeTheShell) {
  EXPECT_FALSE(isBankBefore({0.0, 0.2, 0.28, 0.0, 0.05}));
  EXPECT_FALSE(isBankBefore({0.3, 0.1, 0.28, 0.0, 0.05}));
}

TEST(IsHeapBefore, IsALineThatExplainsWhatLiesOnIt) {
  EXPECT_TRUE(isBankBefore({-0.3, 0.2, 0.28, 0.005}));
  EXPECT_FALSE(isBankBefore({-0.3, 0.2, 0.28, 0.012}));
}

TEST(IsHeapBefore, HoldsMostOfWhatLiesBeforeTheSurfacesMiddle) {
  EXPECT_TRUE(isBankBefore({-0.3, 0.2, 0.9, 0.0, 0.0, 0.2}));
  EXPECT_FALSE(isBankBefore({-0.3, 0.08, 0.2, 0.0, 0.0, 0.2}));
  EXPECT_FALSE(isBankBefore({-0.3, 0.2, 0.9, 0.0, 0.0, 0.2, 0.024}));  // three in eight stand out of the noise
}

TEST(IsHeapBefore, ReachesFartherThanAWeld) {
  EXPECT_TRUE(isBankBefore({-0.3, 0.1, 0.12, 0.0, 0.0, 0.1, 0.001}));
  EXPECT_FALSE(isBankBefore({-1.0, 0.045, 0.06, 0.0, 0.0, 0.055, 0.001}));
}

TEST(IsHeapBefore, LiesUpToThreeTenthsOfTheReachAbove) {
  EXPECT_TRUE(isBankBefore({-0.3, 0.1, 0.28, 0.0, 0.1, 0.1}));
  EXPECT_FALSE(isBankBefore({-0.3, 0.1, 0.28, 0.0, 0.2, 0.1}));
}

}  // namespace tank_datum::foot_heaps_test
