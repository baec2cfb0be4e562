#include "foot/grazed_arcs.h"

#include <gtest/gtest.h>

#include "support/made_feet.h"

namespace tank_datum::grazed_arcs_test {

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
  FootPass pass = levelPass(0.5 * made.step(), kFar);
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

/// A surface beside a shell, as dense as what lies lower beyond its end.
struct Slope {
  double slope = 0.06;  ///< rising outwards [m/m]
  double beams = 0.12;  ///< tangent of the beams' angle to what is level
  double end = 0.103;   ///< of the surface, from the shell [m]
  double scatter = 0.0;
  double on_line = 0.0;   ///< share of what lies beyond that is in line with it
  double dense = 1000.0;  ///< points of a station and metre
  double below = 0.0;     ///< points in its stead beside the shell, lower, over as many as usual
};

/// The same but for one of its figures.
Slope with(double Slope::*figure, double value, Slope slope = {}) {
  slope.*figure = value;
  return slope;
}

/// Whether an arc of it is grazed.
bool isGrazed(const Slope& seen) {
  constexpr double kLower = -0.03;
  constexpr int kArc = 10;
  const double begin = seen.below > 0.0 ? 0.043 : kNear;
  MadeFoot made;
  const int on_shell = static_cast<int>(std::lround(seen.dense * 0.4 * kReach / seen.beams));
  const auto points = [&](double share, double from, double to) {
    return static_cast<int>(std::lround(share * seen.dense * (to - from)));
  };
  const auto rising = [&](double d) { return seen.slope * (d - 0.5 * (kNear + seen.end)); };
  for (int station = -kArc; station <= kArc; ++station) {
    const int i = (station + 360) % 360;
    int count = i;
    made.addStation(i, points(seen.below, kNear, begin), kNear, begin, [](double) { return kLower; });
    made.addStation(i, points(1.0, begin, seen.end), begin, seen.end,
                    [&](double d) { return rising(d) + (++count % 2 == 0 ? seen.scatter : -seen.scatter); });
    made.addStation(i, points(seen.on_line, seen.end, kFar), seen.end, kFar, [](double) { return 0.0; });
    made.addStation(i, points(1.0 - seen.on_line, seen.end, kFar), seen.end, kFar, [](double) { return kLower; });
    made.addShell(i, on_shell);
  }
  FootPass pass = levelPass(0.5 * made.step(), kFar);
  pass.sections.whole.noise = 0.0025;
  return findGrazedArcs(made.foot(), pass, pass.fits)[0];
}

TEST(FindGrazedArcs, FindsADenseSurfaceThatRisesAsBeamsDo) {
  EXPECT_TRUE(isGrazed(Slope{}));
  EXPECT_FALSE(isGrazed(Slope{0.06, 0.24}));
  EXPECT_FALSE(isGrazed(Slope{0.04, 0.1}));  // as a lip may
  EXPECT_FALSE(isGrazed(Slope{0.0}));
}

TEST(FindGrazedArcs, LeavesASlopeThatChanceExplains) {
  const Slope few = with(&Slope::dense, 100.0);
  EXPECT_TRUE(isGrazed(with(&Slope::scatter, 0.004, few)));
  EXPECT_FALSE(isGrazed(with(&Slope::scatter, 0.008, few)));
}

TEST(FindGrazedArcs, LeavesARiseOfTwoStrips) {
  EXPECT_FALSE(isGrazed(Slope{0.06, 0.12, 0.033}));
  EXPECT_TRUE(isGrazed(Slope{0.06, 0.12, 0.063}));
}

TEST(FindGrazedArcs, LeavesASlopeThatDoesNotEnd) { EXPECT_FALSE(isGrazed(Slope{0.06, 0.12, kFar})); }

TEST(FindGrazedArcs, SeesWhereTheSurfaceEndsByMostOfThePoints) {
  EXPECT_TRUE(isGrazed(with(&Slope::on_line, 0.4)));
  EXPECT_FALSE(isGrazed(with(&Slope::on_line, 0.6)));
}

TEST(FindGrazedArcs, TakesFewPointsBelowForNoEnd) {
  EXPECT_TRUE(isGrazed(with(&Slope::below, 0.4)));
  EXPECT_FALSE(isGrazed(with(&Slope::below, 0.6)));
}

TEST(FindGrazedArcs, CannotTellWhereTheShellShowsFewPoints) { EXPECT_FALSE(isGrazed(Slope{0.06 * 60.0, 7.2 * 10.0})); }

}  // namespace tank_datum::grazed_arcs_test
