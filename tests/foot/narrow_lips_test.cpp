#include "foot/narrow_lips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/made_narrow_lips.h"

namespace tank_datum::narrow_lips_test {

using namespace made_narrow_lips;

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

}  // namespace tank_datum::narrow_lips_test
