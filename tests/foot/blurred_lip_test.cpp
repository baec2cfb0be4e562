#include <gtest/gtest.h>

#include "support/made_narrow_lips.h"

namespace tank_datum::blurred_lip_test {

using namespace made_narrow_lips;

/// A ringwall seen from 30 mm on through noise that hides all thicknesses of a plate; beside the shell what is seen
/// rises by so much, and scatters by 10 mm to either side.
/// @param first,last  shares of what lies between 2.5 standard deviations of the shell's noise and 30 mm
/// @param elsewhere  what it rises by farther than 20 degrees from the station at 100
Scene blurred(double shell_noise, double rise, double first, double last, double elsewhere) {
  Scene scene;
  scene.has_lip = [](int) { return false; };
  scene.noise = 0.008;
  scene.shell_noise = shell_noise;
  const double from = 2.5 * shell_noise, width = 0.030 - from;
  const double begin = from + first * width, end = from + last * width;
  scene.add = [=](MadeFoot& made) {
    for (int s = 0; s < 360; ++s) {
      for (int k = 0; k < 20; ++k) {
        const double height = (std::abs(s - 100) <= 20 ? rise : elsewhere) + 0.010 * ((k + 0.5) / 10.0 - 1.0);
        const double d = begin + (end - begin) * ((7 * k) % 20 + 0.5) / 20.0;
        made.addStation(s, 1, d, d, [height](double) { return height; });
      }
    }
  };
  return scene;
}

Scene blurred(double shell_noise, double rise, double first = 0.0, double last = 1.0) {
  return blurred(shell_noise, rise, first, last, rise);
}

/// One part of the ring that rises, of two; the other falls, so that the ring does not rise.
Scene blurredPart(double shell_noise, double rise) {
  Scene scene = blurred(shell_noise, rise, 0.0, 0.33, -0.2 * rise);
  scene.stands = [](int s) { return std::abs(s - 100) <= 20 || (s >= 140 && s < 340); };
  return scene;
}

double sigmaOf(const Scene& scene) { return lipsOf(scene)[100].sigma; }

TEST(BlurredLip, IsTwiceWhatRisesOfWhichSigmaHoldsHalf) {
  EXPECT_NEAR(sigmaOf(blurred(0.0065, 0.006, 0.0, 0.33)), 0.006, 0.0015);
  EXPECT_EQ(lipsOf(blurred(0.0065, 0.006))[100].height, 0.0) << "nothing is raised";
}

TEST(BlurredLip, IsHiddenByNoiseAsWideAsFifteenMillimetres) {
  EXPECT_EQ(sigmaOf(blurred(0.0055, 0.009)), 0.0);
  EXPECT_GT(sigmaOf(blurred(0.0065, 0.009)), 0.0);
}

TEST(BlurredLip, RisesByMoreThanChance) {  // 60 points that scatter by 7.4 mm: 1.2 mm
  EXPECT_EQ(sigmaOf(blurredPart(0.0065, 0.0025)), 0.0);
  EXPECT_GT(sigmaOf(blurredPart(0.0065, 0.0050)), 0.0);
}

TEST(BlurredLip, RisesRoundTheRingWhereOneStationShowsTooFewPoints) {  // 7200 points: 0.1 mm
  EXPECT_EQ(sigmaOf(blurred(0.0065, 0.0002, 0.0, 0.33)), 0.0);
  EXPECT_NEAR(sigmaOf(blurred(0.0065, 0.0025, 0.0, 0.33)), 0.0025, 0.0005);
}

TEST(BlurredLip, IsSeenInTheNearestThird) {
  EXPECT_GT(sigmaOf(blurred(0.0065, 0.006, 0.2, 0.3)), 0.0);
  EXPECT_EQ(sigmaOf(blurred(0.0065, 0.006, 0.4, 0.6)), 0.0);
}

TEST(BlurredLip, OfTheUsualWidthMayBeHiddenWhole) {
  EXPECT_EQ(sigmaOf(blurred(0.019, 0.0)), 0.0);
  EXPECT_NEAR(sigmaOf(blurred(0.021, 0.0)), 0.005, 1e-4);
}

}  // namespace tank_datum::blurred_lip_test
