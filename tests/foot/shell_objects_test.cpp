#include "foot/shell_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tank_datum/core/unknown.h"

namespace tank_datum::shell_objects_test {

constexpr double kRadius = 5.0, kArc = 0.02;

/// A round shell of cells 20 mm long.
ShellCells round(std::size_t count = 1440) { return {std::vector<double>(count, kRadius), 0.001, kArc}; }

/// Cells from `first` on, round the ring, so far off the shell.
void put(ShellCells& cells, std::size_t first, std::size_t length, double off) {
  for (std::size_t i = first; i < first + length; ++i) cells.radius[i % cells.radius.size()] = kRadius + off;
}

std::size_t countUnknown(const std::vector<double>& radius) {
  return static_cast<std::size_t>(std::count_if(radius.begin(), radius.end(), [](double r) { return std::isnan(r); }));
}

/// "-" for each cell of the shell, "." for each that is taken out, "o" for what is left of an object.
std::string pictureOf(const std::vector<double>& radius) {
  std::string text;
  for (const double r : radius) text += std::isnan(r) ? '.' : std::abs(r - kRadius) < 0.001 ? '-' : 'o';
  return text;
}

TEST(WithoutObjects, LeavesAShellAsItIs) {
  EXPECT_EQ(countUnknown(withoutObjects(round())), 0u);
  ShellCells lobes = round();
  for (std::size_t i = 0; i < 1440; ++i) lobes.radius[i] += 0.1 * std::sin(static_cast<double>(i) * kArc);  // 1 in 10
  EXPECT_EQ(countUnknown(withoutObjects(lobes)), 0u);
}

TEST(WithoutObjects, TakesOutWhatStandsOffTheCellsOnBothSides) {
  for (const double off : {0.13, -0.13}) {
    ShellCells cells = round(40);
    put(cells, 10, 4, off);
    EXPECT_EQ(pictureOf(withoutObjects(cells)), std::string(10, '-') + "...." + std::string(26, '-'));
  }
  ShellCells cells = round(40);
  put(cells, 38, 4, 0.13);  // over the first cell
  EXPECT_EQ(pictureOf(withoutObjects(cells)), ".." + std::string(36, '-') + "..");
}

TEST(WithoutObjects, AnEdgeMayBeBlendedInSteps) {
  ShellCells cells = round(80);
  put(cells, 10, 6, 0.06), put(cells, 11, 4, 0.13);
  EXPECT_EQ(pictureOf(withoutObjects(cells)), std::string(10, '-') + "......" + std::string(64, '-'));
}

TEST(WithoutObjects, OfManyObjectsTheShellBetweenIsLeft) {
  ShellCells cells = round(400);
  for (std::size_t first = 0; first < 400; first += 20) put(cells, first + 3, 8, 0.13);
  const std::vector<double> radius = withoutObjects(cells);
  EXPECT_EQ(countUnknown(radius), 160u);
  EXPECT_EQ(std::count_if(radius.begin(), radius.end(), [](double r) { return r > kRadius + 0.01; }), 0);
}

TEST(WithoutObjects, AStepOfTheShellIsNoObject) {
  ShellCells half = round(100);
  put(half, 50, 50, 0.05);  // both halves are as long
  EXPECT_EQ(countUnknown(withoutObjects(half)), 0u);
  ShellCells stairs = round(100);
  put(stairs, 20, 80, 0.05), put(stairs, 25, 75, 0.1);  // 20 to 24 lie between, not off
  EXPECT_EQ(countUnknown(withoutObjects(stairs)), 0u);
}

TEST(WithoutObjects, AnEighthOfTheRingIsNone) {
  ShellCells cells = round(400);
  put(cells, 100, 48, 0.2);
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 48u);
  cells = round(400);
  put(cells, 100, 52, 0.2);
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 0u);
}

TEST(WithoutObjects, WhatIsNotSeenBetweenMayHoldTheShellsOwnTurn) {
  ShellCells cells = round(400);
  put(cells, 100, 100, kUnknown), put(cells, 200, 20, 0.2);  // 2 m in which a lobe may turn by 0.3 m
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 100u);
  put(cells, 100, 80, 0.0);  // 0.4 m in which it may not
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 40u);
}

TEST(WithoutObjects, NothingSeenIsNothingTakenOut) {
  ShellCells cells = round(40);
  put(cells, 0, 40, kUnknown);
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 40u);
  cells.radius[7] = kRadius;
  EXPECT_EQ(countUnknown(withoutObjects(cells)), 39u);
}

std::ptrdiff_t countBefore(const ShellCells& cells, bool inside = false) {
  const std::vector<bool> before = partsBefore(cells, inside, 0.03);
  return std::count(before.begin(), before.end(), true);
}

TEST(PartsBefore, CladdingIsBetweenAStepTowardsTheScannerAndOneBack) {
  ShellCells cells = round();
  put(cells, 1300, 400, 0.05);
  EXPECT_EQ(countBefore(cells), 400);
  EXPECT_EQ(countBefore(cells, true), 0) << "from inside it is the shell between two parts that stand inwards";
  put(cells, 1300, 400, -0.05);
  EXPECT_EQ(countBefore(cells, true), 400);
  EXPECT_EQ(countBefore(round()), 0);
  put(cells, 1300, 400, 0.006);
  EXPECT_EQ(countBefore(cells), 0) << "a shell may turn as much";
}

TEST(PartsBefore, PlatesOfTheShellAreNone) {
  ShellCells cells = round();
  put(cells, 1300, 400, 0.028);
  EXPECT_EQ(countBefore(cells), 0);
  put(cells, 1300, 400, 0.032);
  EXPECT_EQ(countBefore(cells), 400);
  for (const std::size_t edge : {1299U, 260U}) cells.radius[edge] = kRadius + 0.02;
  EXPECT_EQ(countBefore(cells), 400) << "an edge blends with both of its sides";
}

TEST(PartsBefore, NoneIsToldWhereItIsMostOfWhatIsSeen) {
  ShellCells cells = round();
  put(cells, 0, 700, 0.05);
  EXPECT_EQ(countBefore(cells), 700);
  put(cells, 0, 740, 0.05);
  EXPECT_EQ(countBefore(cells), 0);
  for (std::size_t i = 20; i < 700; ++i) cells.radius[i] = kUnknown;
  EXPECT_EQ(countBefore(cells), 740) << "60 of 760 that show something";
}

TEST(PartsBefore, AStepThatIsNotTakenBackIsNone) {
  ShellCells cells = round();
  for (std::size_t i = 200; i < 600; ++i) cells.radius[i] += 0.05 * static_cast<double>(600 - i) / 400.0;
  EXPECT_EQ(countBefore(cells), 0);
}

TEST(MostTurn, IsFourDeviationsAndFifteenHundredthsOfTheArc) {
  EXPECT_NEAR(mostTurn({{}, 0.002, kArc}, 1.0), 0.158, 1e-12);
}

}  // namespace tank_datum::shell_objects_test
