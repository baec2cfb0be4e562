#include "shell/shell_grid.h"

#include <gtest/gtest.h>

#include "support/made_shells.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::shell_grid_test {

using namespace made_shells;

ShellGrid gridOf(const Points& points, const StationOptions& around = {}) {
  return fitShellGrid(bandsOf(points), stations(around), tank10().circle, {});
}

std::size_t seenIn(const std::vector<ShellCell>& row) {
  return static_cast<std::size_t>(std::count_if(row.begin(), row.end(), [](const auto& c) { return c.seen(); }));
}

TEST(FitShellGrid, OfAnExactShellIsItsRadiusAtEveryHeight) {
  MadeShell shell;
  shell.radius = [](double a, double h) { return kRadius + 0.02 * std::cos(2 * a) + 0.003 * h * std::sin(a); };
  const ShellGrid grid = gridOf(shell.points());
  ASSERT_EQ(grid.heights.size(), 5U);
  EXPECT_NEAR(grid.step, kTurn * kRadius / 360, 1e-12);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(seenIn(grid.cells[k]), 360U);
    for (std::size_t i = 0; i < 360; ++i) {
      EXPECT_NEAR(grid.cells[k][i].radius, shell.radius(kTurn * static_cast<double>(i) / 360, grid.heights[k]), 2e-5);
    }
  }
}

TEST(FitShellGrid, NoiseIsNoBiasAndSigmaSaysHowMuchIsLeft) {
  MadeShell shell;
  shell.noise = 0.003;
  shell.count = 900'000;
  const ShellGrid grid = gridOf(shell.points());
  double sum = 0, squares = 0, within = 0, count = 0;
  for (const auto& row : grid.cells) {
    for (const ShellCell& cell : row) {
      const double error = cell.radius - kRadius;
      sum += error, squares += error * error / (cell.sigma * cell.sigma), ++count;
      within += std::abs(error) < 2.0 * cell.sigma;
    }
  }
  EXPECT_EQ(count, 5 * 360);
  EXPECT_LT(std::abs(sum / count), 5e-5);
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.15);
  EXPECT_GT(within / count, 0.92);
}

TEST(FitShellGrid, HeightsCountFromEachStationsOwnElevation) {
  MadeShell shell;
  shell.radius = [](double, double h) { return kRadius + 0.01 * h; };
  std::vector<Station> around = stations();
  for (Station& s : around) s.z += 0.05 * std::cos(s.direction);
  around[90].z = kUnknown;  // takes its neighbours'
  const ShellGrid grid = fitShellGrid(bandsOf(shell.points()), around, tank10().circle, {});
  EXPECT_NEAR(grid.cells[1][0].radius, kRadius + 0.01 * 1.35, 1e-5);
  EXPECT_NEAR(grid.cells[1][180].radius, kRadius + 0.01 * 1.25, 1e-5);
  EXPECT_NEAR(grid.cells[1][90].radius, kRadius + 0.01 * 1.30, 1e-5);
}

TEST(FitShellGrid, WhatIsNotSeenIsNoCell) {
  MadeShell shell;
  shell.seen = [](double a, double h) { return a < 5.0 && (h < 2.0 || a < 2.0); };
  const ShellGrid grid = gridOf(shell.points());
  ASSERT_EQ(grid.heights.size(), 5U);
  const auto station = [](double a) { return static_cast<std::size_t>(a / kTurn * 360); };
  EXPECT_NEAR(static_cast<double>(seenIn(grid.cells[0])), 5.0 / kTurn * 360, 2.0);
  EXPECT_NEAR(static_cast<double>(seenIn(grid.cells[3])), 2.0 / kTurn * 360, 2.0);
  EXPECT_FALSE(grid.cells[0][station(5.5)].seen());
  EXPECT_FALSE(grid.cells[3][station(3.0)].seen());
  EXPECT_TRUE(grid.cells[3][station(1.0)].seen());
}

TEST(FitShellGrid, CoarseStationsLookAtADegreeAsFineOnesDo) {
  MadeShell shell;
  shell.radius = [](double a, double) { return kRadius + 0.03 * std::cos(20 * a); };
  StationOptions coarse;
  coarse.count = 12;
  const ShellGrid grid = gridOf(shell.points(), coarse);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(grid.cells[0][i].radius, shell.radius(kTurn * static_cast<double>(i) / 12, 0.3), 2e-4);
  }
}

TEST(FitShellGrid, ARoofIsNoShell) {
  MadeShell shell;
  shell.radius = [](double, double h) { return kRadius - std::max(0.0, h - 2.1); };  // at 45 degrees
  shell.to = 2.4;
  EXPECT_EQ(gridOf(shell.points()).heights.size(), 2U);
}

/// A thing over some degrees this far in front of the shell, hiding it.
MadeShell behind(double gap, double from, double to) {
  MadeShell shell;
  shell.noise = 0.002;
  shell.radius = [=](double a, double h) {
    const bool hidden = a > from && a < to && h > 0.5 && h < 3.0;
    return kRadius + 0.02 * std::cos(3 * a) + (hidden ? gap : 0.0);
  };
  return shell;
}

/// Rows with a cell of a shell of that noise each, the last of the underside of a girder as wide as that.
std::size_t rowsBelowGirder(double noise, double wide) {
  MadeShell shell;
  shell.noise = noise;
  Points points;
  std::mt19937_64 random(5);
  for (const Eigen::Vector3d& p : shell.points()) {
    if (p.z() < kFoot + 3.5) points.push_back(p);
  }
  for (int i = 0; i < 2000; ++i) {  // before one scanner
    const double a = 1.0 + 0.1 * uniform(random), r = kRadius + wide * uniform(random);
    points.emplace_back(kCentre.x() + r * std::cos(a), kCentre.y() + r * std::sin(a),
                        kFoot + 4.3 + 0.0005 * uniform(random));
  }
  return gridOf(points).heights.size();
}

TEST(FitShellGrid, TheUndersideOfAWindGirderIsNoShell) {
  EXPECT_EQ(rowsBelowGirder(0.001, 0.6), 4U);
  EXPECT_EQ(rowsBelowGirder(0.001, 0.002), 5U) << "a shell that is seen in few places there";
}

constexpr std::size_t kThere = 180;

/// The row of a tank of five metres of which a degree lies `off` the shell, which is hidden for so many degrees before
/// and behind it.
std::vector<ShellCell> rowWith(double off, double hidden_before, double hidden_behind) {
  constexpr double kSmall = 5.0, kDegree = kTurn / 360.0, kAt = 180.0 * kDegree, kHalf = 0.5 * kDegree;
  MadeShell shell;
  shell.noise = 0.001;
  shell.from = 0.1, shell.to = 0.5;
  shell.radius = [=](double a, double) { return kSmall + (std::abs(a - kAt) < kHalf ? off : 0.0); };
  shell.seen = [=](double a, double) {
    const double beside = a - kAt;
    return std::abs(beside) < kHalf || beside < -kHalf - hidden_before * kDegree ||
           beside > kHalf + hidden_behind * kDegree;
  };
  Tank tank = tank10();
  tank.circle.radius = kSmall;
  ShellBands bands(tank, everyMetre());
  bands.gather(0, shell.points());
  return fitShellGrid(bands, stations(), tank.circle, everyMetre()).cells.front();
}

TEST(FitShellGrid, AJumpBesideAGapMayBeTheEdgeOfSomething) {
  const auto takes = [](double off, double before, double behind) {
    return rowWith(off, before, behind)[kThere].seen();
  };
  EXPECT_TRUE(takes(0.030, 0.0, 0.0)) << "a peaked weld";
  EXPECT_FALSE(takes(0.030, 0.0, 5.0));
  EXPECT_FALSE(takes(0.030, 5.0, 0.0));
  EXPECT_FALSE(takes(-0.030, 0.0, 5.0));
  EXPECT_TRUE(takes(0.005, 0.0, 5.0)) << "a shell bends by as much";
  EXPECT_TRUE(takes(0.030, 5.0, 5.0)) << "nothing beside it says what it is";
}

TEST(FitShellGrid, WhatJumpsIsInDoubtAndJoinsNothing) {
  const std::vector<ShellCell> row = rowWith(-0.030, 0.0, 5.0);
  EXPECT_NEAR(row[kThere].doubted, 5.0 - 0.030, 0.008);
  EXPECT_TRUE(row[kThere - 1].seen());
  EXPECT_FALSE(row[kThere - 1].runs_on) << "to what is seen behind the gap";
  EXPECT_TRUE(std::isnan(row[kThere - 1].doubted));
}

TEST(KeepConnected, AWideThingInFrontOfTheShellIsNotTakenForIt) {
  const MadeShell shell = behind(0.15, 1.0, 2.0);  // wider than an object
  ShellGrid grid = gridOf(shell.points());
  EXPECT_GT(seenIn(grid.cells[1]), 350U);  // it looks like a shell
  keepConnected(grid);
  const std::size_t hidden = static_cast<std::size_t>(1.0 / kTurn * 360);
  EXPECT_NEAR(static_cast<double>(seenIn(grid.cells[1])), static_cast<double>(360 - hidden), 6.0);
  for (std::size_t i = 0; i < 360; ++i) {
    const double truth = kRadius + 0.02 * std::cos(3 * kTurn * static_cast<double>(i) / 360);
    if (grid.cells[1][i].seen()) {
      EXPECT_NEAR(grid.cells[1][i].radius, truth, 0.003) << i;
    }
  }
  EXPECT_EQ(seenIn(grid.cells[0]), 360U);
}

TEST(KeepConnected, AShellSeenInPartsWithGapsBetweenStaysWhole) {
  MadeShell shell;
  shell.radius = [](double a, double) { return kRadius + 0.04 * std::cos(2 * a); };
  shell.seen = [](double a, double) { return std::fmod(a, kTurn / 4) < 0.5; };
  ShellGrid grid = gridOf(shell.points());
  const std::size_t before = seenIn(grid.cells[0]);
  keepConnected(grid);
  EXPECT_EQ(seenIn(grid.cells[0]), before);
  EXPECT_GT(before, 100U);
}

TEST(KeepConnected, ABuckleIsPartOfTheShell) {
  MadeShell shell;
  shell.noise = 0.001;
  shell.radius = [](double a, double h) {
    return kRadius - 0.08 * std::exp(-0.5 * std::pow((a - 3.0) / 0.05, 2) - 0.5 * std::pow((h - 2.3) / 0.8, 2));
  };
  ShellGrid grid = gridOf(shell.points());
  keepConnected(grid);
  EXPECT_EQ(seenIn(grid.cells[2]), 360U);
  const auto station = static_cast<std::size_t>(std::lround(3.0 / kTurn * 360));
  EXPECT_NEAR(grid.cells[2][station].radius, kRadius - 0.08, 0.003);
}

TEST(KeepConnected, TheShellIsWhatIsSeenLowest) {  // and not cladding of more of it
  MadeShell shell;
  shell.radius = [](double, double h) { return kRadius + (h > 1.0 ? 0.08 : 0.0); };
  ShellGrid grid = gridOf(shell.points());
  keepConnected(grid);
  EXPECT_EQ(seenIn(grid.cells[0]), 360U);
  for (std::size_t k = 1; k < grid.cells.size(); ++k) EXPECT_EQ(seenIn(grid.cells[k]), 0U) << grid.heights[k];
}

TEST(KeepConnected, ButNotWhatIsSeenOfHalfTheRingOrLessThere) {
  MadeShell shell;
  shell.radius = [](double, double h) { return kRadius + (h < 1.0 ? 0.08 : 0.0); };
  shell.seen = [](double a, double h) { return h > 1.0 || a < 3.0; };
  ShellGrid grid = gridOf(shell.points());
  keepConnected(grid);
  EXPECT_EQ(seenIn(grid.cells[0]) + seenIn(grid.cells[1]), 360U);
}

TEST(KeepConnected, WhatIsLeftOutBehindTheShellIsDoubted) {
  for (const double off : {-0.06, 0.06}) {
    MadeShell shell;
    shell.noise = 0.001;
    shell.radius = [=](double a, double h) { return kRadius + (a > 1.0 && a < 1.2 && h > 1.0 && h < 3.0 ? off : 0.0); };
    ShellGrid grid = gridOf(shell.points());
    keepConnected(grid);
    const ShellCell& cell = grid.cells[1][63];
    ASSERT_FALSE(cell.seen()) << off;
    EXPECT_EQ(std::isfinite(cell.doubted), off < 0.0);
    EXPECT_TRUE(off > 0.0 || std::abs(cell.doubted - kRadius - off) < 0.003);
  }
}

TEST(KeepConnected, NothingStaysNothing) {
  ShellGrid grid = gridOf({});
  EXPECT_TRUE(grid.heights.empty());
  keepConnected(grid);
  EXPECT_TRUE(grid.cells.empty());
}

}  // namespace tank_datum::shell_grid_test
