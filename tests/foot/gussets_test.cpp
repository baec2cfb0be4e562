#include "foot/gussets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "foot/shell_fits.h"
#include "support/made_rings.h"

namespace tank_datum::gussets_test {

using made_rings::levelTank;

constexpr double kRadius = 10.0, kReach = 0.5;  // m
constexpr int kColumns = 3142;                  // round the ring

/// A shell, and before it plates that stand out from it, in columns of points one upon the other.
struct Scan {
  int on = 24;                      ///< points of a column on the shell
  int out = 36;                     ///< of one on a plate
  double from = 0.005, to = 0.150;  ///< how far out from the shell a plate is seen [m]
  int plates = 24;                  ///< round the ring
  int wide = 1;                     ///< columns that a plate takes
  double beside = 0.0;              ///< of the points on the shell, that a plate's columns show [share]
  double high = 0.43;               ///< [m]
  bool leans = false;               ///< the farther out, the higher

  bool isPlate(int column) const { return column % (kColumns / plates) < wide; }

  PolarRing ring() const {
    Points points;
    const auto add = [&](int column, double off, int i, int count) {
      const double a = (column + 0.5 + (i % 2 ? 0.25 : -0.25)) * kTwoPi / kColumns, r = kRadius + off,
                   h = 0.06 + high * (i + 0.5) / count;
      points.emplace_back(r * std::cos(a), r * std::sin(a), h);
    };
    for (int column = 0; column < kColumns; ++column) {
      const int shell = isPlate(column) ? static_cast<int>(std::lround(beside * on)) : on;
      for (int i = 0; i < shell; ++i)
        add(column, 0.001 * (std::fmod(0.618034 * (i + 101 * column), 1.0) - 0.5), i, shell);
      if (!isPlate(column)) continue;
      for (int i = 0; i < out; ++i)
        add(column, from + (to - from) * (leans ? (i + 0.5) / out : std::fmod(0.618034 * i, 1.0)), i, out);
    }
    return PolarRing(points, {0.0, 0.0});
  }

  /// How many points are left out.
  std::size_t leftOut(double noise = 0.0005) const {
    const PolarRing all = ring();
    const ShellOutline outline{std::vector<double>(360, kRadius), noise};
    const auto others = withoutGussets(all, outline, levelTank(kRadius), {0.05, kReach});
    return others ? all.points().size() - others->points().size() : 0;
  }
};

TEST(WithoutGussets, OfAShellAloneNothingIsLeftOut) {
  Scan scan;
  scan.out = 0, scan.beside = 1.0;
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, TheColumnsOfPlatesAreLeftOutNoOthers) {
  const Scan scan;
  EXPECT_NEAR(static_cast<double>(scan.leftOut()), 36.0 * 24.0, 36.0);
}

TEST(WithoutGussets, AColumnIsAPlatesThatShowsHalfAsManyPointsOutAsOnTheShell) {
  Scan scan;
  scan.beside = 1.0, scan.to = 0.045;
  scan.out = 14;
  EXPECT_GT(scan.leftOut(), 0U);
  scan.out = 10;
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, OfFewerThanThreePointsThereIsNoPlate) {
  Scan scan;
  scan.to = 0.045, scan.high = 0.03;  // of a layer
  scan.out = 3;
  EXPECT_GT(scan.leftOut(), 0U);
  scan.out = 2;
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, WhatIsSeenFurtherThanATenthOfTheHeightsOutIsNotSeen) {
  Scan scan;
  scan.from = 0.026, scan.to = 0.049;
  EXPECT_GT(scan.leftOut(), 0U);
  scan.from = 0.051, scan.to = 0.090;
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, AQuarterOfTheRingIsNoPlates) {
  Scan scan;
  scan.plates = 1;
  scan.wide = static_cast<int>(0.22 * kColumns);
  EXPECT_GT(scan.leftOut(), 0U);
  scan.wide = static_cast<int>(0.28 * kColumns);
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, AWallThatLeansOutIsNone) {
  Scan scan;
  scan.leans = true, scan.to = 0.045;
  EXPECT_EQ(scan.leftOut(), 0U);
}

TEST(WithoutGussets, PointsOfALayerLieThreeHundredthsOfTheHeightsApart) {
  Scan scan;
  scan.from = 0.030, scan.to = 0.044;
  EXPECT_EQ(scan.leftOut(), 0U);
  scan.from = 0.026, scan.to = 0.049;
  EXPECT_GT(scan.leftOut(), 0U);
}

TEST(WithoutGussets, NoiseOfAHundredthOfTheHeightsHidesThem) {
  EXPECT_GT(Scan().leftOut(0.0048), 0U);
  EXPECT_EQ(Scan().leftOut(0.0052), 0U);
}

TEST(WithoutGussets, AColumnIsATwentyFifthOfTheHeightsWide) {
  Scan scan;
  scan.plates = kColumns / 8, scan.to = 0.045;
  scan.out = 11, scan.beside = 0.5;  // of two columns together less than half of what the shell shows
  EXPECT_GT(scan.leftOut(), 0U);
  scan.out = 4, scan.beside = 0.25, scan.high = 0.03;  // two in half of a column
  EXPECT_GT(scan.leftOut(), 0U);
}

TEST(FitShellLines, BesideAGussetAreTheShells) {
  std::vector<double> directions;
  for (int i = 0; i < 360; ++i) directions.push_back(toRadians(i));
  Scan scan;
  scan.wide = 2;
  const PolarRing ring = scan.ring();
  const ShellFits shell = fitShellLines(directions, ring, levelTank(kRadius), kReach);
  for (const ShellLine& line : shell.lines) {
    if (line.seen()) {
      EXPECT_NEAR(line.radius, kRadius, 0.001);
    }
  }
}

}  // namespace tank_datum::gussets_test
