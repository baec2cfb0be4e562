#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/shell_circle.h"
#include "foot/shell_fits.h"
#include "support/made_rings.h"

namespace tank_datum::shell_bounds_test {

using made_rings::levelTank;

constexpr double kRadius = 10.0, kReach = 0.5;

/// An upright shell of so many points, evenly round; `bump` further out where told [rad].
Points shellOf(int count, double bump = 0.0, double from = 0.0, double to = 0.0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double a = kTwoPi * (i + 0.5) / count, h = 0.16 + 0.33 * std::fmod(0.618034 * i, 1.0);
    const double r = kRadius + 1e-6 * std::cos(7.0 * i) + (a > from && a < to ? bump : 0.0);
    points.push_back({r * std::cos(a), r * std::sin(a), h});
  }
  return points;
}

TEST(OutlineBand, ACellHoldsFortyPoints) {
  EXPECT_EQ(outlineBand(PolarRing(shellOf(8000), {0.0, 0.0}), kRadius).radius.size(), 8000U / 40U);
}

TEST(OutlineBand, AShellTurnsByAtMostFifteenHundredthsOverFourCells) {
  // 200 cells of 314 mm: 0.15 of 1.26 m
  const auto stands = [](double bump) {
    const double cell = kTwoPi / 200.0;
    const auto ring = PolarRing(shellOf(8000, bump, 50.0 * cell, 51.0 * cell), {0.0, 0.0});
    return std::isfinite(outlineBand(ring, kRadius).radius[50]);
  };
  EXPECT_TRUE(stands(0.17));
  EXPECT_FALSE(stands(0.21));
}

TEST(FitShellLine, ABoxBeforeTheShellMovesNoLineBesideIt) {
  const double cell = kTwoPi / 200.0, from = 50.0 * cell, to = 56.0 * cell;
  const PolarRing ring(shellOf(8000, 0.13, from, to), {0.0, 0.0});
  const ShellOutline outline = outlineShell(ring, levelTank(kRadius), kReach);
  const auto lineAt = [&](double azimuth) {
    return fitShellLine(ring, outline, {azimuth, 2.0 * cell, 0.0, {0.1, kReach}});
  };
  EXPECT_FALSE(lineAt(0.5 * (from + to)).seen());
  EXPECT_NEAR(lineAt(from - cell).radius, kRadius, 1e-4) << "half of what is before it is the box";
  EXPECT_NEAR(lineAt(to + cell).radius, kRadius, 1e-4);
}

TEST(FitShellLine, TwelvePointsTellItsFourUnknownsElevenDoNot) {
  const ShellOutline outline{std::vector<double>(36, kRadius), 0.001};
  const auto seen = [&](int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any;
    Points points;
    for (int i = 0; i < count; ++i) {
      const double a = 1.0 + 0.02 * (any(random) - 0.5);
      points.push_back({kRadius * std::cos(a), kRadius * std::sin(a), 0.1 + 0.4 * any(random)});
    }
    return fitShellLine(PolarRing(points, {0.0, 0.0}), outline, {1.0, 0.02, 0.0, {0.05, kReach}}).seen();
  };
  EXPECT_TRUE(seen(12));
  EXPECT_FALSE(seen(11));
}

TEST(ShellLine, IsSupportedWithinAStepWhoseColumnsAreUpToAQuarterFurtherApart) {
  ShellLine line;
  line.before = line.after = 0.60;
  EXPECT_TRUE(line.isSupportedWithin(1.0));
  line.before = line.after = 0.65;
  EXPECT_FALSE(line.isSupportedWithin(1.0));
}

std::size_t pointsOfALine(int per_degree) {
  const PolarRing ring(shellOf(360 * per_degree), {0.0, 0.0});
  std::vector<double> directions;
  for (int i = 0; i < 360; ++i) directions.push_back(toRadians(i));
  return fitShellLines(directions, ring, levelTank(kRadius), kReach).lines[100].points;
}

TEST(FitShellLines, AStationWidensItsWindowByHalvesUntilItHasFortyPoints) {
  EXPECT_NEAR(static_cast<double>(pointsOfALine(15)), 45.0, 3.0);  // of a degree to either side: 30
}

TEST(FitShellLines, AStationBorrowsFromNoFurtherThanFiveDegrees) {
  EXPECT_NEAR(static_cast<double>(pointsOfALine(5)), 5.0 * 2.0 * 3.375, 2.0);  // a degree and a half, thrice, is 3.4
}

TEST(ShellCircle, LinesSixSigmasOffAreNoShell) {
  const auto radius = [](double off) {
    std::vector<ShellLine> lines(360);
    std::vector<double> azimuths;
    for (std::size_t i = 0; i < 360; ++i) {
      lines[i].radius = kRadius + (i % 12 == 0 ? off : i % 2 == 0 ? 0.001 : -0.001) / 1.4826;
      lines[i].points = 10;
      azimuths.push_back(toRadians(static_cast<double>(i)));
    }
    return fitShellCircle(lines, azimuths, {0.05, 0.5}, {{0.0, 0.0}, kRadius}, {},
                          std::vector<bool>(lines.size(), true))
        .circle.radius;
  };
  const double without = radius(0.0);
  EXPECT_GT(radius(0.0065) - without, 0.0002);
  EXPECT_LT(std::abs(radius(0.0130) - without), 0.0001);
}

}  // namespace tank_datum::shell_bounds_test
