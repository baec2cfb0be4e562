#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "trust/shell_evidence.h"

namespace tank_datum::shell_evidence_bounds_test {

constexpr double kReach = 0.5;

Tank tankOf(double radius) {
  Tank tank;
  tank.circle = {{1.0, -2.0}, radius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return tank;
}

/// Walls that are seen at single azimuths, as upright rows of points.
class Rows {
 public:
  explicit Rows(double radius) : tank_(tankOf(radius)) { ring_.reach = kReach; }

  /// Points from one height to another, evenly, `off` outside of the shell.
  void add(double degrees, int count, double from, double to, double off = 0.0) {
    for (int i = 0; i < count; ++i) addPoint(degrees, from + (to - from) * (i + 0.5) / count, off);
  }

  void addPoint(double degrees, double height, double off) {
    const double a = toRadians(degrees), r = tank_.circle.radius + off;
    ring_.points.emplace_back(tank_.circle.center.x() + r * std::cos(a), tank_.circle.center.y() + r * std::sin(a),
                              height);
  }

  /// Rows of the shell at so many azimuths, evenly round from 0.2 degrees on.
  void addShell(int rows, int points = 40) {
    for (int i = 0; i < rows; ++i) add(0.2 + 360.0 / rows * i, points, 0.1, 0.5);
  }

  ShellEvidence look() const { return lookAtShell(ring_, tank_); }

 private:
  Tank tank_;
  Ring ring_;
};

TEST(ShellEvidence, IsKnownFromEightSectors) {
  for (const int rows : {7, 8}) {
    Rows wall(5.0);
    wall.addShell(rows);
    EXPECT_EQ(wall.look().sectors, static_cast<std::size_t>(rows));
    EXPECT_EQ(wall.look().known(), rows == 8);
  }
}

TEST(ShellEvidence, FivePointsOfASectorHaveAMiddle) {
  for (const int points : {4, 5}) {
    Rows wall(5.0);
    wall.addShell(20);
    wall.add(100.0, points, 0.1, 0.5);
    EXPECT_EQ(wall.look().sectors, points < 5 ? 20U : 21U);
  }
}

TEST(ShellEvidence, AWallStandsWithinATenthOfTheRadius) {
  for (const double off : {0.19, 0.21}) {
    Rows wall(2.0);
    wall.addShell(20);
    wall.add(100.0, 40, 0.1, 0.5, off);
    wall.add(208.0, 40, 0.1, 0.5, -off);
    EXPECT_EQ(wall.look().sectors, off < 0.2 ? 22U : 20U);
  }
}

TEST(ShellEvidence, AWallStandsClearOfTheFootByFifteenHundredthsOfTheReach) {
  for (const double top : {0.073, 0.087}) {
    Rows wall(5.0);
    wall.addShell(20);
    wall.add(100.0, 40, top - 0.01, top);
    EXPECT_EQ(wall.look().sectors, top < 0.15 * kReach ? 20U : 21U);
  }
}

/// A shell whose rows are 1 mm thick, with a thing before the top of each so many millimetres outside.
ShellEvidence withThingsAtTheTop(double millimetres) {
  Rows wall(5.0);
  for (int row = 0; row < 20; ++row) {
    const double degrees = 0.2 + 18.0 * row;
    for (int i = 0; i < 14; ++i) {
      for (const double off : {-0.001, 0.0, 0.001}) wall.addPoint(degrees, 0.1 + 0.4 * i / 14.0, off);
    }
    for (int i = 0; i < 4; ++i) wall.addPoint(degrees, 0.5 - 1e-6, 0.001 * millimetres);
  }
  return wall.look();
}

/// The median deviation of a row is 1 mm: five standard deviations are 7.4 mm.
TEST(ShellEvidence, BeyondFiveSigmasAnotherThingStandsBeforeTheWall) {
  EXPECT_GT(withThingsAtTheTop(7.2).cone, 0.005);
  EXPECT_NEAR(withThingsAtTheTop(7.6).cone, 0.0, 1e-9);
}

/// Every other sector of 7.5 degrees holds a row of 40 points over 0.39 m.
TEST(ShellEvidence, TheSpacingIsThatOfTheSectorsOf7Point5DegreesInWhichAWallIsSeen) {
  Rows wall(5.0);
  wall.addShell(24);
  EXPECT_NEAR(wall.look().spacing, std::sqrt(toRadians(7.5) * 5.0 * 0.39 / 40.0), 1e-9);
}

TEST(ShellEvidence, HasADegreeASectorAtMost) {
  Rows wall(5.0);
  for (int row = 0; row < 1440; ++row) wall.add(0.1 + 0.25 * row, 15, 0.1, 0.5);
  const ShellEvidence shell = wall.look();
  EXPECT_LT(3.0 * shell.spacing, toRadians(0.9) * 5.0);  // as small as would be seen in more sectors
  EXPECT_EQ(shell.sectors, 360U);
}

/// What the wall seems to open by where a heap lies against most of it: its top so high, its points up to 0.4 m outside
/// of the shell, which stands so far outside of the circle there, and so many strays below.
double coneBehindHeap(double top, double shell = 0.0, int strays = 0) {
  Rows wall(10.0);
  wall.addShell(40);
  for (int k = 0; k < 80; ++k) {
    const double at = 0.2 + 360.0 / 120.0 * k;
    wall.add(at, 20, top, 0.5, shell);
    for (int i = 0; i < 60; ++i) {  // it falls by as much as it is wide
      const double off = 0.4 * (i + 0.5) / 60;
      if (top - off > 0.08) wall.addPoint(at, top - off, shell + off);
    }
    for (int i = 0; i < strays; ++i) wall.addPoint(at, 0.08, 0.0);
  }
  return std::abs(wall.look().cone);
}

TEST(ShellEvidence, AHeapAgainstTheShellIsNoWall) {
  EXPECT_LT(coneBehindHeap(0.3), 0.01);
  EXPECT_LT(coneBehindHeap(0.3, 0.07), 0.01) << "of a shell out of round";
  EXPECT_LT(coneBehindHeap(0.3, 0.0, 1), 0.01) << "a stray point below it";
  EXPECT_GT(coneBehindHeap(0.3, 0.0, 3), 0.1) << "the shell below it";
}

TEST(ShellEvidence, AWallThatBeginsBelowThreeTenthsOfTheReachIsWhole) {
  Rows wall(5.0);
  for (int i = 0; i < 40; ++i) wall.add(0.2 + 9.0 * i, 40, 0.1, 0.257);  // tells its lean by all of its points only
  EXPECT_TRUE(std::isfinite(wall.look().cone));
}

}  // namespace tank_datum::shell_evidence_bounds_test
