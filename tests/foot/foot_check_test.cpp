#include "foot/foot_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_clouds.h"

namespace tank_datum::foot_check_test {

using made_clouds::kTurn;
using made_clouds::uniform;

constexpr double kNoise = 0.0005;
constexpr double kStep = 0.5;  // arc between 360 stations of a tank of 29 m radius [m]

FootFit fitOf(double z, double sigma = 0.0002) {
  FootFit fit;
  fit.z = z, fit.sigma = sigma;
  fit.slope = 0.0, fit.sigma_slope = 0.001;
  fit.noise = kNoise;
  fit.points = 100;
  return fit;
}

/// 360 stations on a smooth datum: a tilt of 50 mm and an oval of 20 mm amplitude.
std::vector<FootFit> smoothRing() {
  std::vector<FootFit> fits;
  for (int i = 0; i < 360; ++i) {
    const double a = kTurn * i / 360;
    fits.push_back(fitOf(2.0 + 0.05 * std::cos(a) + 0.02 * std::cos(2 * a) + 0.004 * std::cos(8 * a)));
  }
  return fits;
}

void raise(std::vector<FootFit>& fits, std::size_t first, std::size_t count, double by) {
  for (std::size_t i = 0; i < count; ++i) fits[(first + i) % fits.size()].z += by;
}

/// Which stations are dropped.
std::vector<std::size_t> droppedOf(const std::vector<FootFit>& fits, double step = kStep) {
  const std::vector<bool> dropped = findSteps(fits, step, [](const StepRun&) { return false; }).dropped;
  EXPECT_EQ(dropped.size(), fits.size());
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    if (dropped[i]) which.push_back(i);
  }
  return which;
}

TEST(FindSteps, SmoothHarmonicsAreKept) { EXPECT_TRUE(droppedOf(smoothRing()).empty()); }

TEST(FindSteps, SoilUnderThirtyDegreesIsDropped) {
  auto fits = smoothRing();
  raise(fits, 100, 30, 0.030);
  const auto dropped = droppedOf(fits);
  ASSERT_EQ(dropped.size(), 30U);
  EXPECT_EQ(dropped.front(), 100U);
  EXPECT_EQ(dropped.back(), 129U);
}

TEST(FindSteps, AcrossTheSeamToo) {
  auto fits = smoothRing();
  raise(fits, 350, 20, 0.030);
  EXPECT_EQ(droppedOf(fits).size(), 20U);
  EXPECT_EQ(droppedOf(fits)[10], 350U);
}

TEST(FindSteps, TheGreaterPartIsKept) {
  auto fits = smoothRing();
  raise(fits, 100, 250, 0.030);
  const auto dropped = droppedOf(fits);
  ASSERT_EQ(dropped.size(), 110U);
  EXPECT_EQ(dropped.front(), 0U);
  EXPECT_EQ(dropped.back(), 359U);
}

TEST(FindSteps, TwoHeapsAndALoneStation) {
  auto fits = smoothRing();
  raise(fits, 40, 30, 0.060);
  raise(fits, 200, 15, 0.030);
  raise(fits, 300, 1, -0.020);
  EXPECT_EQ(droppedOf(fits).size(), 46U);
}

TEST(FindSteps, AcrossAGapTheArcIsThatOfTheGap) {
  auto fits = smoothRing();
  for (std::size_t i = 0; i < 360; ++i) fits[i].z += 0.4 * std::cos(kTurn * static_cast<double>(i) / 360);
  for (const std::size_t first : {85U, 265U}) {  // 70 mm in 5 m, down and up again
    for (std::size_t i = first; i < first + 10; ++i) fits[i] = {};
  }
  EXPECT_TRUE(droppedOf(fits).empty());
}

TEST(FindSteps, AStepIsAQuestionOfArcAndOfSigma) {
  auto fits = smoothRing();
  raise(fits, 100, 30, 0.030);
  EXPECT_TRUE(droppedOf(fits, 2.0).empty());  // 40 mm in 2 m is what a shell may do
  for (FootFit& fit : fits) fit.sigma = 0.010;
  EXPECT_TRUE(droppedOf(fits).empty());
}

/// Stations dropped of a ring where ten lie so far off the others, to which the shell is seen to go down or not.
std::size_t droppedWhereTenLie(double off, bool shell) {
  auto fits = smoothRing();
  for (std::size_t i = 100; i < 110; ++i) fits[i].z += off;
  std::size_t asked = 0;
  const Steps steps = findSteps(fits, kStep, [&](const StepRun& run) {
    EXPECT_EQ(run.stations.size(), 10U);
    EXPECT_NEAR(run.beside, std::min(fits[99].z, fits[110].z), 1e-12);
    return ++asked, shell;
  });
  EXPECT_EQ(asked, off < 0.0 ? 1U : 0U);
  const auto count = [](const std::vector<bool>& is) { return std::count(is.begin(), is.end(), true); };
  EXPECT_EQ(count(steps.dropped) + count(steps.dips), 10);
  return static_cast<std::size_t>(count(steps.dropped));
}

TEST(FindSteps, StationsToWhichTheShellIsSeenToGoDownAreADip) {
  EXPECT_EQ(droppedWhereTenLie(-0.05, true), 0U);
  EXPECT_EQ(droppedWhereTenLie(-0.05, false), 10U);
  EXPECT_EQ(droppedWhereTenLie(0.05, true), 10U) << "what lies higher may be soil";
}

TEST(FindSteps, OfNothingDropNothing) {
  EXPECT_TRUE(findSteps({}, kStep, [](const StepRun&) { return false; }).dropped.empty());
  EXPECT_TRUE(droppedOf(std::vector<FootFit>(360)).empty());
  EXPECT_TRUE(droppedOf({fitOf(2.0)}).empty());
}

/// How many are dropped of a level ring with a gap, behind which 40 stations begin so far below the others and end 20
/// mm below them.
std::size_t droppedBehindGap(std::size_t gap, double low) {
  std::vector<FootFit> fits(360, fitOf(2.0));
  for (std::size_t i = 0; i < gap; ++i) fits[100 + i] = {};
  for (std::size_t i = 0; i < 40; ++i) fits[100 + gap + i].z -= low + (0.020 - low) * static_cast<double>(i) / 39.0;
  return droppedOf(fits, 0.2).size();
}

TEST(FindSteps, WhereARingHasAStepALikeDifferenceOverAGapIsOneToo) {
  EXPECT_EQ(droppedBehindGap(10, 0.020), 40U);
  // half of the step's height, and 2 mm/m over eleven steps of 0.2 m
  EXPECT_EQ(droppedBehindGap(10, 0.0148), 40U);
  EXPECT_EQ(droppedBehindGap(10, 0.0140), 0U);
  EXPECT_EQ(droppedBehindGap(1, 0.0112), 40U);
  EXPECT_EQ(droppedBehindGap(1, 0.0104), 0U);
  EXPECT_EQ(droppedBehindGap(40, 0.020), 0U) << "a datum may climb by so much over eight metres";
}

}  // namespace tank_datum::foot_check_test
