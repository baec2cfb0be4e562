#include "foot/narrow_lips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/made_feet.h"

namespace tank_datum {
namespace {

using made_feet::MadeFoot;

/// A ringwall upon z = 0 from 30 mm on, two points a millimetre and station, and what lies beside the shell.
struct Scene {
  double from = 0.008, to = 0.026, height = 0.008;              ///< of a lip [m]
  double noise = 0.0003;                                        ///< of the fits [m]
  double shell_noise = 0.001;                                   ///< [m]
  double density = 2000.0;                                      ///< points a station [1/m]
  std::function<bool(int)> has_lip = [](int) { return true; };  ///< at a station
  std::function<bool(int)> stands = [](int) { return true; };
  std::function<void(MadeFoot&)> add = [](MadeFoot&) {};
};

std::vector<Lift> lipsOf(const Scene& scene) {
  MadeFoot made;
  made.addAll(static_cast<int>(0.25 * scene.density), 0.03, 0.28, [](double) { return 0.0; });
  std::vector<FootFit> fits(360);
  for (int s = 0; s < 360; ++s) {
    const int points = static_cast<int>(std::lround(scene.density * (scene.to - scene.from)));
    if (scene.has_lip(s)) made.addStation(s, points, scene.from, scene.to, [&](double) { return scene.height; });
    if (!scene.stands(s)) continue;
    FootFit& fit = fits[static_cast<std::size_t>(s)];
    fit.sigma = 0.0002, fit.noise = scene.noise;
    fit.z = fit.slope = fit.along = fit.bend = 0.0;
  }
  scene.add(made);
  FootSections sections;
  sections.whole.band_from = 0.03, sections.whole.band_to = 0.28;
  sections.whole.surface = Surface::Ringwall;
  return findNarrowLips(made.foot({0.3, scene.shell_noise, 0.013}), fits, sections);
}

Scene lip(double from, double to, double height = 0.008) {
  Scene scene;
  scene.from = from, scene.to = to, scene.height = height;
  return scene;
}

bool isRaised(const Scene& scene) { return lipsOf(scene)[100].height > 0.0; }

TEST(NarrowLips, RaiseTheRingByTheirHeight) {
  for (const Lift& lift : lipsOf({})) {
    EXPECT_NEAR(lift.height, 0.008, 1e-6);
    EXPECT_NEAR(lift.sigma, 0.03 * 0.017, 2e-5) << "what leans by 0.03 m/m, seen 17 mm from the shell";
  }
}

TEST(NarrowLips, AreSevenMillimetresWideAtLeast) {
  EXPECT_TRUE(isRaised(lip(0.008, 0.0165)));
  EXPECT_FALSE(isRaised(lip(0.008, 0.0145)));
}

/// From 2 mm on, and 2.5 standard deviations of the shell's points; these scatter a lip's by as much.
TEST(NarrowLips, BeginWhereTheShellIsNot) {
  EXPECT_TRUE(isRaised(lip(0.0025, 0.0105)));
  EXPECT_FALSE(isRaised(lip(0.0015, 0.0100)));
  Scene quiet = lip(0.0, 0.0088);
  quiet.shell_noise = 0.0004;
  EXPECT_FALSE(isRaised(quiet));
  quiet.to = 0.0098;
  EXPECT_TRUE(isRaised(quiet));
}

TEST(NarrowLips, LieHalfAPlateToThirtyMillimetresHigher) {
  EXPECT_FALSE(isRaised(lip(0.008, 0.026, 0.002)));
  EXPECT_TRUE(isRaised(lip(0.008, 0.026, 0.003)));
  EXPECT_TRUE(isRaised(lip(0.008, 0.026, 0.029)));
  EXPECT_FALSE(isRaised(lip(0.008, 0.026, 0.033)));
}

TEST(NarrowLips, AreLevelAsFarAsNoiseTells) {
  Scene noisy;
  noisy.noise = 0.002;  // levels are 8 mm thick: a fillet of 0.5 m/m is 16 mm wide
  EXPECT_TRUE(isRaised(noisy));
  noisy.noise = 0.0025;
  EXPECT_FALSE(isRaised(noisy));
}

/// Beams meet the face of a weld more densely than a level surface.
TEST(NarrowLips, AreNoWelds) {
  Scene weld;
  weld.has_lip = [](int) { return false; };
  weld.add = [](MadeFoot& made) { made.addAll(400, 0.002, 0.013, [](double d) { return 0.013 - d; }); };
  EXPECT_FALSE(isRaised(weld));
}

TEST(NarrowLips, AreNoFillets) {
  Scene mastic;
  mastic.has_lip = [](int) { return false; };
  mastic.noise = 0.0007;  // levels are 2.8 mm thick, 9 mm of it
  mastic.add = [](MadeFoot& made) { made.addAll(120, 0.004, 0.034, [](double d) { return 0.3 * (0.034 - d); }); };
  EXPECT_FALSE(isRaised(mastic));
}

/// A lip with one point at every so many stations, anywhere on it.
Scene sparseLip(int every, double to, double density) {
  Scene sparse;
  sparse.has_lip = [](int) { return false; };
  sparse.density = density;
  sparse.add = [every, to](MadeFoot& made) {
    for (int s = 0; s < 360; s += every) {
      const double d = 0.008 + (to - 0.008) * std::fmod(0.618034 * s, 1.0);
      made.addStation(s, 1, d, d, [](double) { return 0.008; });
    }
  };
  return sparse;
}

TEST(NarrowLips, OfSparseScansAreSeenWithinFifteenDegrees) {
  EXPECT_TRUE(isRaised(sparseLip(3, 0.026, 20.0))) << "ten points";
  EXPECT_FALSE(isRaised(sparseLip(5, 0.026, 20.0))) << "six";
}

TEST(NarrowLips, AreTwelvePointsOfTheNarrowestAtLeast) {
  EXPECT_TRUE(isRaised(sparseLip(1, 0.019, 132.0))) << "13 points beside 430 of the surface";
}

/// Scans show the face of an edge more densely than what it ends.
TEST(NarrowLips, AreLevelBeforeTheirEdge) {
  Scene edge = sparseLip(1, 0.024, 20.0);
  EXPECT_TRUE(isRaised(edge));
  const auto lip = edge.add;
  edge.add = [lip](MadeFoot& made) {
    lip(made);
    for (int s = 0; s < 360; s += 2)
      made.addStation(s, 3, 0.025, 0.027, [](double d) { return 0.008 - 2.0 * (d - 0.025); });
  };
  EXPECT_TRUE(isRaised(edge));
}

/// A weld's toe is steep, the lip beyond it level.
TEST(NarrowLips, AreLevelBeyondAWeldsToe) {
  Scene weld;
  weld.has_lip = [](int) { return false; };
  weld.add = [](MadeFoot& made) {
    made.addAll(36, 0.004, 0.026, [](double d) { return 0.0072 + std::max(0.0, 0.2 * (0.0115 - d)); });
  };
  EXPECT_TRUE(isRaised(weld));
}

TEST(NarrowLips, StandOutOfTheSurfacesOwnScatter) {
  Scene noisy = lip(0.008, 0.026, 0.0028);
  EXPECT_TRUE(isRaised(noisy));
  noisy.noise = 0.001;
  EXPECT_FALSE(isRaised(noisy));
}

TEST(NarrowLips, HideWhatTheyLieOn) {
  Scene cable = lip(0.016, 0.028);
  EXPECT_TRUE(isRaised(cable));
  cable.add = [](MadeFoot& made) { made.addAll(10, 0.004, 0.016, [](double) { return 0.0; }); };
  EXPECT_FALSE(isRaised(cable));
  cable.add = [](MadeFoot& made) { made.addAll(4, 0.004, 0.016, [](double) { return 0.0; }); };
  EXPECT_TRUE(isRaised(cable)) << "a sixth of its points";
  cable.add = [](MadeFoot& made) { made.addAll(10, 0.004, 0.016, [](double) { return 0.0008; }); };
  EXPECT_TRUE(isRaised(cable)) << "not on the surface";
}

/// Points at any height, as of plants or of a shell that noise blurs, are at each height by chance.
TEST(NarrowLips, AreDenserThanChance) {
  Scene plants;
  plants.has_lip = [](int) { return false; };
  plants.noise = 0.001;
  plants.add = [](MadeFoot& made) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> height(0.0, 0.05);
    made.addAll(400, 0.005, 0.026, [&](double) { return height(random); });
  };
  const auto lifts = lipsOf(plants);
  EXPECT_EQ(std::count_if(lifts.begin(), lifts.end(), [](const Lift& lift) { return lift.height > 0.0; }), 0);
}

TEST(NarrowLips, OfFewStationsAreNone) {
  Scene some;
  some.has_lip = [](int s) { return s % 360 < 170; };
  EXPECT_FALSE(isRaised(some));
  some.has_lip = [](int s) { return s % 360 < 190; };
  const auto lifts = lipsOf(some);
  EXPECT_NEAR(lifts[300].height, 0.008, 1e-6);
  EXPECT_NEAR(lifts[300].sigma, std::hypot(0.004, 0.03 * 0.017), 1e-4) << "not seen there";
}

/// Stations 100 to 160 show a lip, behind gaps of so many degrees.
std::vector<Lift> lipsOfPart(int gap) {
  Scene island;
  island.has_lip = [](int s) { return s >= 100 && s <= 160; };
  island.stands = [gap](int s) { return (s >= 100 && s <= 160) || s < 100 - gap || s > 160 + gap; };
  return lipsOf(island);
}

TEST(NarrowLips, OfAPartOfTheRingRaiseThatPart) {
  const auto apart = lipsOfPart(9);
  EXPECT_NEAR(apart[130].height, 0.008, 1e-6);
  EXPECT_EQ(apart[50].height, 0.0);
  EXPECT_EQ(apart[50].sigma, 0.0);
  EXPECT_EQ(lipsOfPart(4)[130].height, 0.0) << "one part with the rest";
}

TEST(NarrowLips, RaiseWhatIsBridgedBetweenParts) {
  Scene gap;
  gap.stands = [](int s) { return s < 91 || s > 99; };
  EXPECT_NEAR(lipsOf(gap)[95].height, 0.008, 1e-6);
  const Lift between = lipsOfPart(9)[95];  // the fifth of nine
  EXPECT_NEAR(between.height, 0.004, 1e-6);
  EXPECT_NEAR(between.sigma, std::hypot(0.004, 0.03 * 0.017), 1e-4);
}

TEST(NarrowLips, OfMostStationsHaveAUsualHeight) {
  std::vector<FootFit> fits(4);
  for (int i : {0, 1, 2}) fits[static_cast<std::size_t>(i)].sigma = 0.001;
  EXPECT_EQ(usualLip({{0.008, 0.0}, {0.009, 0.0}, {}, {}}, fits), 0.0085);
  EXPECT_EQ(usualLip({{0.008, 0.0}, {}, {}, {}}, fits), 0.0);
}

}  // namespace
}  // namespace tank_datum
