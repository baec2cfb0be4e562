#include "foot/shell_circle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_clouds.h"

namespace tank_datum {
namespace {

constexpr double kRadius = 10.0;

/// Lines of a shell about (0.02, -0.01), one per degree of the first `seen` degrees, as they are measured from (0, 0).
std::vector<ShellLine> linesOf(int seen, double radius, double noise = 0.0) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<ShellLine> lines(360);
  for (int i = 0; i < seen; ++i) {
    const double a = i * kPi / 180.0;
    ShellLine& line = lines[static_cast<std::size_t>(i)];
    line.radius = radius + 0.02 * std::cos(a) - 0.01 * std::sin(a) + noise * normal(random);
    line.points = 10;
  }
  return lines;
}

std::vector<double> degrees() {
  std::vector<double> azimuths;
  for (int i = 0; i < 360; ++i) azimuths.push_back(i * kPi / 180.0);
  return azimuths;
}

ShellCircle fitted(const std::vector<ShellLine>& lines, const CirclePrior& prior = {}) {
  return fitShellCircle(lines, degrees(), {0.05, 0.5}, {{0, 0}, kRadius}, prior);
}

TEST(ShellCircle, OfExactLinesIsExact) {
  const ShellCircle round = fitted(linesOf(360, 10.003));
  EXPECT_NEAR(round.circle.radius, 10.003, 1e-6);
  EXPECT_NEAR(round.circle.center.x(), 0.02, 1e-6);
  EXPECT_NEAR(round.circle.center.y(), -0.01, 1e-6);
  EXPECT_LT(round.sigma_radius, 1e-6);
}

TEST(ShellCircle, OfTooFewLinesIsTheStart) {
  const ShellCircle round = fitted(linesOf(4, 10.003));
  EXPECT_EQ(round.circle.radius, kRadius);
  EXPECT_TRUE(std::isnan(round.sigma_radius));
}

TEST(ShellCircle, AShortArcIsHeldByWhatTheWholeShellSaid) {
  const auto lines = linesOf(60, 10.003, 0.01);
  const ShellCircle alone = fitted(lines), held = fitted(lines, {0.001, 0.05});
  EXPECT_GT(alone.sigma_radius, 0.005);
  EXPECT_LT(held.sigma_radius, 0.0011);
  EXPECT_NEAR(held.circle.radius, kRadius, 0.002);
}

TEST(ShellCircle, AWholeFootOutweighsTheLocatedCircle) {
  EXPECT_NEAR(fitted(linesOf(360, 10.003, 0.001), {0.005, 0.05}).circle.radius, 10.003, 0.0003);
}

Tank seenOver(double coverage_deg, double rms) {
  Tank tank;
  tank.coverage = coverage_deg * kPi / 180.0;
  tank.rms = rms;
  tank.height = 10.0;
  return tank;
}

TEST(PriorOf, IsNothingForLessThanHalfOfTheShell) {
  EXPECT_TRUE(std::isinf(priorOf(seenOver(170, 0.01)).sigma_radius));
  EXPECT_TRUE(std::isinf(priorOf(seenOver(360, 0.0)).sigma_radius));
  EXPECT_TRUE(std::isinf(priorOf(Tank{}).sigma_center));
}

TEST(PriorOf, KnowsTheRadiusByTheCellsAndTheCentreByTheLean) {
  const CirclePrior prior = priorOf(seenOver(360, 0.012));
  EXPECT_NEAR(prior.sigma_radius, 0.002, 1e-9);
  EXPECT_NEAR(prior.sigma_center, std::hypot(0.002, 0.05), 1e-9);
}

}  // namespace
}  // namespace tank_datum
