#include "foot/grazed_arcs.h"

#include <gtest/gtest.h>

#include "support/made_feet.h"

namespace tank_datum {
namespace {

using namespace made_feet;

/// What lies beside a shell, before a crown.
struct Gap {
  double points = 3;        ///< of a station and 10 mm
  double slope = 0.1;       ///< rising outwards [m/m]
  double crown = 0.009;     ///< over what is nearest to the shell [m]
  double crown_at = 0.093;  ///< from the shell [m]
  double seen_to = 0.083;   ///< of what lies before it [m]
  double scatter = 0.0003;
  double plants = 0;  ///< points of a station and 10 mm that stand above it
};

constexpr double kNear = 0.013, kFar = 0.463;
constexpr double kUsual = 10.0;  // points of a station and 10 mm on the crown

/// Adds what lies beside the shell at a station.
void addGap(MadeFoot& made, int station, const Gap& gap) {
  const auto points = [](double density, double from, double to) {
    return static_cast<int>(std::lround(density * (to - from) / 0.01));
  };
  int count = 0;
  made.addStation(station, points(gap.points, kNear, gap.seen_to), kNear, gap.seen_to,
                  [&](double d) { return gap.slope * (d - kNear) + (++count % 2 == 0 ? gap.scatter : -gap.scatter); });
  made.addStation(station, points(gap.plants, kNear, gap.seen_to), kNear, gap.seen_to, [](double) { return 0.03; });
  made.addStation(station, points(kUsual, gap.crown_at, kFar), gap.crown_at, kFar, [&](double) { return gap.crown; });
}

/// Whether a station whose neighbours to some number are like it, and all others unlike, is in a grazed arc.
bool isGrazed(const Gap& gap, int neighbours = 180, const Gap& others = {10.0, 0.0}) {
  MadeFoot made;
  for (int i = 0; i < 360; ++i) addGap(made, i, std::min(i, 360 - i) <= neighbours ? gap : others);
  FootFit fit;
  fit.z = fit.slope = 0.0, fit.sigma = 0.0002;
  FootPass pass;
  pass.fits.assign(360, fit);
  pass.priors.slope.assign(360, 0.0);
  pass.sections.whole.noise = 0.0025;
  return findGrazedArcs(made.foot(), pass, pass.fits)[0];
}

TEST(FindGrazedArcs, FindsFewPointsThatRiseToACrown) { EXPECT_TRUE(isGrazed({})); }

TEST(FindGrazedArcs, LeavesALipThatIsSeenInFull) { EXPECT_FALSE(isGrazed({10.0})); }

TEST(FindGrazedArcs, LeavesWhatHasHalfOfTheUsualPoints) {
  EXPECT_TRUE(isGrazed({4.5}));
  EXPECT_FALSE(isGrazed({5.5}));
}

TEST(FindGrazedArcs, LeavesALipOfWhichTwentyMillimetresAreSeen) {
  Gap lip{10.0, 0.1};
  lip.seen_to = 0.030;
  EXPECT_FALSE(isGrazed(lip));
  lip.seen_to = 0.020;  // may be the shell's own blend
  EXPECT_TRUE(isGrazed(lip));
}

TEST(FindGrazedArcs, LooksForACrownWithinHalfOfThirtyStrips) {
  Gap wide{3.0, 0.1, 0.015};
  wide.seen_to = 0.15, wide.crown_at = 0.16;
  EXPECT_TRUE(isGrazed(wide));
  wide.seen_to = 0.19, wide.crown_at = 0.20;  // how many points are usual is not known
  EXPECT_FALSE(isGrazed(wide));
}

TEST(FindGrazedArcs, TakesNoPlantsForACrown) {
  Gap gap;
  gap.plants = 2;
  EXPECT_TRUE(isGrazed(gap));
}

TEST(FindGrazedArcs, LooksAtWhatLiesHigherThanNoiseAndBend) {
  EXPECT_TRUE(isGrazed({3.0, 0.1, 0.0075}));
  EXPECT_FALSE(isGrazed({3.0, 0.1, 0.0045}));
}

TEST(FindGrazedArcs, LooksAtStationsWithinSevenDegreesTogether) {
  EXPECT_TRUE(isGrazed({}, 5));
  EXPECT_FALSE(isGrazed({}, 4));
}

TEST(FindGrazedArcs, LeavesWhatRisesByLessThanTwoStandardErrors) {
  Gap few{1.0, 0.05, 0.0075};
  few.scatter = 0.006;
  EXPECT_FALSE(isGrazed(few));
  few.scatter = 0.003;
  EXPECT_TRUE(isGrazed(few));
}

TEST(FindGrazedArcs, LeavesWhatIsLevel) {
  EXPECT_FALSE(isGrazed({3.0, 0.0}));
  EXPECT_FALSE(isGrazed({3.0, -0.1}));
}

TEST(FindGrazedArcs, LeavesWhatRisesByLessThanAThirdOfTheWayToTheCrown) {
  // the crown's middle is 20 mm higher and 55 mm farther out
  EXPECT_FALSE(isGrazed({3.0, 0.085, 0.020}));
  EXPECT_TRUE(isGrazed({3.0, 0.125, 0.020}));
}

}  // namespace
}  // namespace tank_datum
