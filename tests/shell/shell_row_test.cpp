#include "shell/shell_row.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_shells.h"

namespace tank_datum::shell_row_test {

using namespace made_shells;

constexpr double kDegree = kTurn / 360.0;

/// The lowest row of a shell.
std::vector<ShellCell> rowOf(MadeShell shell, Side side = Side::Outside) {
  shell.from = 0.1, shell.to = 0.5;
  return fitShellRow(shell.points(), stations(), tank10().circle, std::vector<double>(360, kFoot + 0.3), {0.1, side});
}

/// A shell with something between two azimuths, so far outside of it.
MadeShell with(double off, double from, double to) {
  MadeShell shell;
  shell.noise = 0.001;
  shell.radius = [=](double a, double) { return kRadius + (a > from * kDegree && a < to * kDegree ? off : 0.0); };
  return shell;
}

std::size_t seenIn(const std::vector<ShellCell>& row) {
  return static_cast<std::size_t>(std::count_if(row.begin(), row.end(), [](const auto& c) { return c.seen(); }));
}

/// The largest error where the shell is seen [m].
double worstOf(const std::vector<ShellCell>& row) {
  double worst = 0.0;
  for (const ShellCell& cell : row) {
    if (cell.seen()) worst = std::max(worst, std::abs(cell.radius - kRadius));
  }
  return worst;
}

TEST(FitShellRow, APlateUponTheShellIsNotTheShell) {
  for (const double thick : {0.03, 0.05, 0.1}) {
    const auto row = rowOf(with(thick, 100.3, 106.7));
    EXPECT_NEAR(static_cast<double>(seenIn(row)), 353.0, 2.0) << thick;
    EXPECT_LT(worstOf(row), 0.003) << thick;
  }
}

TEST(FitShellRow, NothingIsFittedOverAnEdge) {  // a cell of few points borrows from 0.4 m on either side
  MadeShell shell = with(0.1, 100.3, 106.7);
  shell.noise = 0.003, shell.count = 60'000;
  EXPECT_LT(worstOf(rowOf(shell)), 0.004);
}

/// Of 70 points a degree, which have to borrow, with strays before 0.1 m of 0.6.
TEST(FitShellRow, StraysInOneCellAreNoEdge) {
  MadeShell shell;
  shell.noise = 0.001, shell.count = 50'000;
  shell.radius = [](double a, double h) {
    const bool before = std::fmod(a, 3.5 * kDegree) < 0.6 * kDegree && std::fmod(1000.0 * h, 1.0) < 0.9;
    return kRadius + (before ? 0.06 : 0.0);
  };
  const auto row = rowOf(shell);
  EXPECT_GT(seenIn(row), 260U);
  EXPECT_LT(worstOf(row), 0.003);
}

TEST(FitShellRow, AnObjectIsLessThanAnEighthOfTheRingWide) {
  EXPECT_LT(worstOf(rowOf(with(0.06, 100.5, 144.5))), 0.003);
  EXPECT_GT(worstOf(rowOf(with(0.06, 100.5, 146.5))), 0.05);
}

TEST(FitShellRow, APadUponTheShellIsNotTheShell) {
  for (const double thick : {0.008, 0.012, 0.02}) {
    const auto row = rowOf(with(thick, 100.3, 106.7));
    EXPECT_NEAR(static_cast<double>(seenIn(row)), 353.0, 2.0) << thick;
    EXPECT_LT(worstOf(row), 0.003) << thick;
  }
}

TEST(FitShellRow, PlatesOfTheShellAreLongerThanPads) {
  EXPECT_LT(worstOf(rowOf(with(0.02, 100.5, 115.5))), 0.003);  // 2.6 m
  EXPECT_GT(worstOf(rowOf(with(0.02, 100.5, 120.5))), 0.018);  // 3.5 m
  EXPECT_LT(worstOf(rowOf(with(0.03, 100.5, 120.5))), 0.003) << "thicker than plates are";
}

/// Of a plate whose upper edge is in the row.
MadeShell withUpperEdge(double from, double to) {
  MadeShell shell = with(0.0, 0.0, 0.0);
  shell.radius = [=](double a, double h) {
    return kRadius + (a > from * kDegree && a < to * kDegree && h < 0.3 ? 0.012 : 0.0);
  };
  return shell;
}

TEST(FitShellRow, NothingIsSeenAtAHorizontalEdge) {
  const auto row = rowOf(withUpperEdge(100.5, 110.5));
  EXPECT_NEAR(static_cast<double>(seenIn(row)), 350.0, 2.0);
  EXPECT_LT(worstOf(row), 0.003);
}

TEST(FitShellRow, ButOfCourses) { EXPECT_GT(seenIn(rowOf(withUpperEdge(0.0, 360.0))), 355U); }

TEST(FitShellRow, AHorizontalEdgeIsLookedForOnBothSidesOfAStation) {
  MadeShell coarse = withUpperEdge(100.5, 110.5);
  coarse.count = 60'000, coarse.from = 0.1, coarse.to = 0.5;  // 11 of a layer within 0.1 m
  StationOptions fine;
  fine.count = 720;
  const std::vector<double> z(720, kFoot + 0.3);
  const auto row = fitShellRow(coarse.points(), stations(fine), tank10().circle, z, {0.1, Side::Outside});
  EXPECT_NEAR(static_cast<double>(seenIn(row)), 700.0, 4.0);
  const auto narrow = rowOf(withUpperEdge(103.3, 104.7));  // 0.24 m
  EXPECT_LT(seenIn(narrow), 360U);
}

TEST(FitShellRow, WhatLiesBetweenCoarseStationsIsDoubted) {
  MadeShell shell;
  shell.noise = 0.001, shell.from = 0.1, shell.to = 0.5;
  shell.radius = [](double a, double) {
    const double t = kRadius * (a - 102.5 * kDegree);
    return kRadius - (std::abs(t) < 0.4 ? 0.05 * (0.5 + 0.5 * std::cos(kTurn * t / 0.8)) : 0.0);
  };
  const auto of = [&](int count) {
    StationOptions options;
    options.count = count;
    const std::vector<double> z(static_cast<std::size_t>(count), kFoot + 0.3);
    return fitShellRow(shell.points(), stations(options), tank10().circle, z, {0.1, Side::Outside});
  };
  EXPECT_NEAR(of(72)[20].doubted, kRadius - 0.05, 0.006);
  EXPECT_NEAR(of(72)[50].doubted, kRadius, 0.002);
  EXPECT_TRUE(std::isnan(of(360)[100].doubted));
}

TEST(FitShellRow, FromInsideAPlateStandsInwards) {
  EXPECT_EQ(seenIn(rowOf(with(-0.06, 100.5, 106.5), Side::Outside)), 360U) << "a dent, however steep";
  EXPECT_LT(seenIn(rowOf(with(-0.06, 100.5, 106.5), Side::Inside)), 356U);
  EXPECT_LT(worstOf(rowOf(with(-0.06, 100.5, 106.5), Side::Inside)), 0.003);
}

TEST(FitShellRow, OfTooFewPointsIsNone) {
  MadeShell shell;
  shell.count = 39;
  EXPECT_TRUE(rowOf(shell).empty());
}

TEST(RunsToNext, NotWhereMostOfTheChangeIsAStep) {
  std::vector<ShellCell> row(4);
  row[0] = {kRadius, 0.0001, 1.0, 100}, row[3] = {kRadius + 0.06, 0.0001, 1.0, 100};
  EXPECT_TRUE(runsToNext(row, 0, 3, 0.2)) << "0.6 m that are not seen";
  row[0].stepped = 0.02;
  EXPECT_TRUE(runsToNext(row, 0, 3, 0.2));
  row[0].stepped = 0.04;
  EXPECT_FALSE(runsToNext(row, 0, 3, 0.2));
  row[0].runs_on = true;
  EXPECT_TRUE(runsToNext(row, 0, 3, 0.2));
}

}  // namespace tank_datum::shell_row_test
