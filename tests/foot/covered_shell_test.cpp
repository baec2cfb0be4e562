#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "foot/shell_line.h"
#include "support/made_clouds.h"
#include "support/made_rings.h"

namespace tank_datum::covered_shell_test {

using made_rings::levelTank;

constexpr double kRadius = 10.0, kReach = 0.5, kNoise = 0.001;

/// The noise of the outline of a shell against which, all round but for a share, lies something that scatters by so
/// much.
double noiseWithSoil(double bare, double soil) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Points points;
  for (int i = 0; i < 40'000; ++i) {
    const double turns = made_clouds::uniform(random), a = kTwoPi * turns;
    const double r = kRadius + (turns < bare ? kNoise : soil) * normal(random);
    points.emplace_back(r * std::cos(a), r * std::sin(a), 0.1 + 0.4 * made_clouds::uniform(random));
  }
  return outlineShell(PolarRing(points, {0, 0}), levelTank(kRadius), kReach).noise;
}

TEST(OutlineShell, TakesItsNoiseFromWhereNoSoilLies) {
  EXPECT_NEAR(noiseWithSoil(0.33, 0.1), kNoise, 0.0003);
  EXPECT_NEAR(noiseWithSoil(0.6, 0.1), kNoise, 0.0003);
}

TEST(OutlineShell, NeedsAQuarterWithoutSoil) {
  EXPECT_LT(noiseWithSoil(0.28, 0.1), 0.003);
  EXPECT_GT(noiseWithSoil(0.2, 0.1), 0.05);
  EXPECT_GT(noiseWithSoil(0.14, 0.1), 0.05);
}

TEST(OutlineShell, IsAsNoisyAsItsUsualCellUpToFourTimesTheQuietest) {
  EXPECT_NEAR(noiseWithSoil(0.33, 0.003), 0.003, 0.0006);
  EXPECT_LT(noiseWithSoil(0.33, 0.006), 0.0015);
}

}  // namespace tank_datum::covered_shell_test
