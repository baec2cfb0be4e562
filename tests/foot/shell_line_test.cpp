#include "foot/shell_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/statistics.h"
#include "support/made_clouds.h"
#include "support/made_rings.h"
#include "support/made_shell_lines.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::shell_line_test {

using made_clouds::kTurn;
using made_clouds::uniform;
using made_rings::levelTank;
using namespace made_shell_lines;

/// A shell of 0.5 m, its foot at z = 0, by its radius against azimuth and height.
struct Shell {
  std::function<double(double, double)> radius = [](double, double) { return kRadius; };
  double noise = 1e-6;
  double from = 0, to = kTurn;  ///< seen arc [rad]
  int count = 40'000;
  std::uint64_t seed = 1;

  Points points() const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Points all;
    for (int i = 0; i < count; ++i) {
      const double a = from + (to - from) * uniform(random), h = kReach * uniform(random);
      const double r = radius(a, h) + noise * normal(random);
      all.emplace_back(r * std::cos(a), r * std::sin(a), h);
    }
    return all;
  }
};

TEST(ShellLine, IsAFormula) {
  ShellLine line;
  EXPECT_FALSE(line.seen());
  EXPECT_TRUE(std::isnan(line.radius));
  line.radius = 10.0, line.turn_slope = 0.1, line.bend = 0.01, line.lean = 0.5;
  EXPECT_DOUBLE_EQ(line.at(2.0, 3.0), 10.0 + 0.2 + 0.04 + 1.5);
}

TEST(FitShellLine, OfAnExactCylinderIsItsRadius) {
  const ShellLine line = lineAt(Shell().points(), 1.0);
  EXPECT_NEAR(line.radius, kRadius, 1e-6);
  EXPECT_NEAR(line.lean, 0.0, 3e-6);
  EXPECT_NEAR(line.turn_slope, 0.0, 3e-6);
  EXPECT_NEAR(line.bend, 0.0, 3e-5);
  EXPECT_LT(line.sigma_radius, 1e-6);
  EXPECT_NEAR(static_cast<double>(line.points), 40'000 * 0.9 / 180, 60);
}

TEST(FitShellLine, TwoColumnsThatSlantDoNotTurnTheShellBetweenThem) {
  Shell shell;
  shell.noise = 0.0007;
  Points points;
  for (const Eigen::Vector3d& p : shell.points()) {
    if (std::abs(std::atan2(p.y(), p.x()) - 1.0) > 1.5 * kStep) points.push_back(p);
  }
  for (int i = 0; i < 40; ++i) {  // range noise of beams that graze the shell: along it, and hardly across
    const double along = 0.0015 * std::sin(2.4 * i), a = 1.0 + 0.8 * kStep + along / kRadius;
    const double r = kRadius + 0.13 * along;
    points.emplace_back(r * std::cos(a), r * std::sin(a), 0.05 + 0.011 * i);
  }
  const ShellLine line = lineAt(points, 1.0);
  ASSERT_TRUE(line.seen());
  EXPECT_LT(std::abs(line.radius - kRadius), 2.0 * line.sigma_radius);
  EXPECT_LT(std::abs(line.radius - kRadius), 0.010);
}

TEST(FitShellLine, OfPointsWithoutNoiseIsSeenToo) {
  Shell shell;
  shell.noise = 0.0;
  EXPECT_TRUE(lineAt(shell.points(), 1.0).seen());
}

TEST(FitShellLine, OfALeaningShellIsTheRadiusAtTheFoot) {
  Shell shell;
  shell.radius = [](double, double h) { return kRadius + 0.03 * h; };
  const ShellLine line = lineAt(shell.points(), 1.0);
  EXPECT_NEAR(line.radius, kRadius, 3e-5);
  EXPECT_NEAR(line.lean, 0.03, 1e-4);
}

TEST(FitShellLine, FollowsLobes) {
  constexpr double kAmplitude = 0.05, kWaves = 12.0;  // 50 mm over waves of 5 m
  Shell shell;
  shell.radius = [](double a, double) { return kRadius + kAmplitude * std::cos(kWaves * a); };
  const Points points = shell.points();
  for (const double a : {0.0, 0.1, 0.5, 3.0}) {
    const ShellLine line = lineAt(points, a);
    EXPECT_NEAR(line.radius, shell.radius(a, 0), 1e-4) << a;
    EXPECT_NEAR(line.turn_slope, -kAmplitude * kWaves / kRadius * std::sin(kWaves * a), 2e-3) << a;
  }
  EXPECT_NEAR(lineAt(points, 0.0).bend, -0.5 * kAmplitude * kWaves * kWaves / kRadius / kRadius, 2e-3);
}

TEST(FitShellLine, LeavesOutTheWeld) {
  Shell shell;
  shell.radius = [](double, double h) { return kRadius + std::max(0.0, 0.05 - h); };
  EXPECT_NEAR(lineAt(shell.points(), 1.0, 0.05).radius, kRadius, 1e-6);
  EXPECT_NEAR(static_cast<double>(lineAt(shell.points(), 1.0, 0.40).points), 40'000 * 0.2 / 180, 30);
}

TEST(FitShellLine, ThirtyPercentOfOutliersDoNotMoveIt) {
  Points points;
  Shell shell;
  shell.noise = 0.001;
  std::mt19937_64 random(9);
  for (auto p : shell.points()) {
    if (uniform(random) < 0.3) p.head<2>() *= 1.0 + 0.04 * (uniform(random) - 0.3);  // -120 to 280 mm
    points.push_back(p);
  }
  for (const double a : {0.5, 2.0, 4.0}) {
    const ShellLine line = lineAt(points, a);
    EXPECT_NEAR(line.radius, kRadius, 4.0 * line.sigma_radius) << a;
    EXPECT_LT(line.sigma_radius, 0.0005);
    EXPECT_NEAR(line.noise, 0.001, 0.0003);
  }
}

TEST(FitShellLine, NorDoPointsALittleInFront) {
  Shell shell;
  shell.noise = 0.001;
  Points points = shell.points();
  for (std::size_t i = 0; i < points.size(); i += 7) points[i].head<2>() *= 1.0005;  // 5 mm: rust, paint, a label
  for (const double a : {0.5, 2.0, 4.0})
    EXPECT_NEAR(lineAt(points, a).radius, kRadius, 0.0004) << a;  // their mean: 0.7
}

TEST(FitShellLine, APipeInFrontIsNotTheShell) {
  Shell shell;
  const double pipe = 1.0;  // hides a degree and a half of the shell
  shell.radius = [&](double a, double) { return std::abs(a - pipe) < 0.75 * kStep ? kRadius + 0.12 : kRadius; };
  const Points points = shell.points();
  for (const double a : {pipe - 2 * kStep, pipe - 1.2 * kStep, pipe, pipe + 1.2 * kStep}) {
    const ShellLine line = lineAt(points, a);
    if (line.seen()) {
      EXPECT_NEAR(line.radius, kRadius, 1e-3) << a;
    }
  }
  EXPECT_TRUE(lineAt(points, pipe - 1.2 * kStep).seen());
}

TEST(FitShellLine, AnUnseenArcIsNotInvented) {
  Shell shell;
  shell.from = 1.0, shell.to = 5.0;
  const Points points = shell.points();
  for (const double a : {0.0, 0.5, 0.9, 5.1, 6.0}) {
    const ShellLine line = lineAt(points, a);
    EXPECT_FALSE(line.seen()) << a;
    EXPECT_TRUE(std::isnan(line.radius));
    EXPECT_TRUE(std::isnan(line.sigma_radius));
  }
  for (const double a : {1.02, 3.0, 4.98}) EXPECT_TRUE(lineAt(points, a).seen()) << a;
}

TEST(FitShellLine, NeedsThreePointsPerUnknown) {
  const Points points = Shell().points();
  EXPECT_TRUE(lineAt(points, 1.0).seen());
  EXPECT_FALSE(lineAt(points, 1.0, 0.05, 0.02 * kStep).seen());
}

TEST(FitShellLine, SigmaIsTheSpreadOfRepeatedScans) {
  std::vector<double> radii, sigmas;
  Shell shell;
  shell.noise = 0.002;
  shell.from = 0.9, shell.to = 1.1, shell.count = 3'000;
  for (shell.seed = 1; shell.seed <= 300; ++shell.seed) {
    const ShellLine line = lineAt(shell.points(), 1.0);
    ASSERT_TRUE(line.seen());
    radii.push_back(line.radius - kRadius);
    sigmas.push_back(line.sigma_radius);
    EXPECT_NEAR(line.noise, shell.noise, 0.0006);
  }
  double squares = 0;
  for (const double r : radii) squares += r * r / 300;
  EXPECT_NEAR(std::sqrt(squares) / median(sigmas), 1.0, 0.15);
}

TEST(OutlineShell, KnowsTheNoiseAndWhereNothingStands) {
  Shell shell;
  shell.noise = 0.002;
  shell.to = 3.0;
  const ShellOutline outline = outlineShell(PolarRing(shell.points(), {0, 0}), levelTank(kRadius), kReach);
  EXPECT_NEAR(outline.noise, 0.002, 0.0006);
  for (const double a : {0.1, 1.0, 2.9}) EXPECT_NEAR(outline.at(a), kRadius, 0.003) << a;
  for (const double a : {3.3, 5.0, 6.0}) EXPECT_TRUE(std::isnan(outline.at(a))) << a;
}

TEST(OutlineShell, InterpolatesAndBridgesThreeCells) {
  ShellOutline outline;
  outline.radius.assign(100, kUnknown);
  outline.radius[0] = 10.0, outline.radius[1] = 11.0;
  const double cell = kTurn / 100;
  EXPECT_NEAR(outline.at(0.5 * cell), 10.0, 1e-9);
  EXPECT_NEAR(outline.at(1.25 * cell), 10.75, 1e-9);
  EXPECT_NEAR(outline.at(4.4 * cell), 11.0, 1e-9);
  EXPECT_TRUE(std::isnan(outline.at(6.4 * cell)));
  EXPECT_NEAR(outline.at(-2.4 * cell), 10.0, 1e-9);
  EXPECT_TRUE(std::isnan(outline.at(-4.5 * cell)));
}

/// Lines of the exact curve r = 10 + 0.05 cos(3 a), every degree from `first`.
std::vector<ShellLine> linesOf(double first) {
  std::vector<ShellLine> lines(360);
  for (std::size_t i = 0; i < 360; ++i) {
    const double a = first + kStep * static_cast<double>(i);
    lines[i].radius = kRadius + 0.05 * std::cos(3 * a);
    lines[i].turn_slope = -0.15 * std::sin(3 * a) / lines[i].radius;
    lines[i].points = 100;
  }
  return lines;
}

TEST(ShellModel, GoesThroughItsLinesAndBetweenThem) {
  for (const double first : {0.0, 1.234, 6.2}) {
    const ShellModel model(linesOf(first), first);
    for (double a = -0.1; a < 6.4; a += 0.01) EXPECT_NEAR(model.at(a), kRadius + 0.05 * std::cos(3 * a), 1e-4) << a;
    EXPECT_NEAR(model.at(first + 5 * kStep), kRadius + 0.05 * std::cos(3 * (first + 5 * kStep)), 1e-9);
  }
}

TEST(ShellModel, IsContinuousWhereLinesDisagree) {
  auto lines = linesOf(0.0);
  for (std::size_t i = 0; i < 360; i += 2) lines[i].radius += 0.002;
  const ShellModel model(lines, 0.0);
  for (int i = -1; i < 361; ++i) {
    EXPECT_NEAR(model.at(i * kStep - 1e-9), model.at(i * kStep + 1e-9), 1e-8) << i;
  }
}

TEST(ShellModel, LeansOnOneNeighbourAndIsUnknownWithoutBoth) {
  auto lines = linesOf(0.0);
  lines[10] = lines[11] = {};
  const ShellModel model(lines, 0.0);
  const auto truth = [](double a) { return kRadius + 0.05 * std::cos(3 * a); };
  EXPECT_NEAR(model.at(9.7 * kStep), truth(9.7 * kStep), 1e-3);
  EXPECT_TRUE(std::isnan(model.at(10.5 * kStep)));
  EXPECT_NEAR(model.at(11.5 * kStep), truth(11.5 * kStep), 1e-3);
}

}  // namespace tank_datum::shell_line_test
