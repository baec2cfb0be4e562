#include "foot/shell_fits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_clouds.h"
#include "support/made_rings.h"

namespace tank_datum::shell_fits_test {

constexpr double kRadius = 10.0, kReach = 0.5;
constexpr int kFirst = 100, kLast = 190;  // clad stations, a degree each

/// A shell of whose part so many millimetres are added 150 mm above the foot, as cladding does.
ShellFits shellClad(double by) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.001);
  Points points;
  for (int i = 0; i < 200'000; ++i) {
    const double a = made_clouds::kTurn * made_clouds::uniform(random), h = kReach * made_clouds::uniform(random);
    const bool clad = a > kFirst * kDegree && a < kLast * kDegree && h > 0.15;
    const double r = kRadius + (clad ? by : 0.0) + noise(random);
    points.emplace_back(r * std::cos(a), r * std::sin(a), h);
  }
  std::vector<double> directions;
  for (int i = 0; i < 360; ++i) directions.push_back(i * kDegree);
  return fitShellLines(directions, PolarRing(points, {0, 0}), made_rings::levelTank(kRadius), kReach);
}

TEST(FitShellLines, CladdingOnAPartIsNotTheShell) {
  const ShellFits shell = shellClad(0.05);
  for (int i = 0; i < 360; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool within = i > kFirst && i<kLast, beside = i> kFirst - 3 && i < kLast + 3;
    if (within) {
      EXPECT_TRUE(shell.clad[at] && !shell.lines[at].seen()) << i;
    }
    if (beside) continue;
    ASSERT_TRUE(!shell.clad[at] && shell.lines[at].seen()) << i;
    EXPECT_NEAR(shell.lines[at].radius, kRadius, 0.001) << i;
  }
}

TEST(FitShellLines, APlateOfTheShellIsNoCladding) {
  for (const double thick : {0.006, 0.022}) {
    const ShellFits shell = shellClad(thick);
    for (std::size_t i = 0; i < 360; ++i) EXPECT_TRUE(!shell.clad[i] && shell.lines[i].seen()) << thick << " at " << i;
  }
}

}  // namespace tank_datum::shell_fits_test
