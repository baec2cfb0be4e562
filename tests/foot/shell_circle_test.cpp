#include "foot/shell_circle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_clouds.h"

namespace tank_datum::shell_circle_test {

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
  return fitShellCircle(lines, degrees(), {0.05, 0.5}, {{0, 0}, kRadius}, prior, std::vector<bool>(lines.size(), true));
}

/// The radius where 60 mm of cladding stand out over so many degrees, of which none is known to be the shell, nor of
/// so many others.
ShellCircle withCladding(std::size_t clad, std::size_t unknown) {
  std::vector<ShellLine> lines = linesOf(360, kRadius);
  std::vector<bool> sure(360, true);
  for (std::size_t i = 0; i < clad + unknown; ++i) sure[i] = false;
  for (std::size_t i = 0; i < clad; ++i) lines[i].radius += 0.06;
  return fitShellCircle(lines, degrees(), {0.05, 0.5}, {{0, 0}, kRadius}, {}, sure);
}

TEST(ShellCircle, BeginsWithWhatIsSurelyTheShell) {
  EXPECT_NEAR(withCladding(85, 0).circle.radius, kRadius, 1e-5);
  EXPECT_NEAR(withCladding(85, 90).circle.radius, kRadius, 1e-5);
  EXPECT_GT(withCladding(85, 100).circle.radius, kRadius + 0.01) << "most of it is not known";
  EXPECT_TRUE(withCladding(85, 0).strays[84]);
  EXPECT_FALSE(withCladding(85, 0).strays[85]);
}

TEST(ShellCircle, OfExactLinesIsExact) {
  const ShellCircle round = fitted(linesOf(360, 10.003));
  EXPECT_NEAR(round.circle.radius, 10.003, 1e-6);
  EXPECT_NEAR(round.circle.center.x(), 0.02, 1e-6);
  EXPECT_NEAR(round.circle.center.y(), -0.01, 1e-6);
  EXPECT_LT(round.sigma_radius, 1e-6);
}

TEST(ShellCircle, OfAShellThatBulgesAllRoundIsThatOfItsFoot) {
  std::vector<ShellLine> lines = linesOf(360, 10.003);
  for (ShellLine& line : lines) line.lean = 0.02;
  EXPECT_NEAR(fitted(lines).circle.radius, 10.003, 1e-5);
  for (ShellLine& line : lines) line.lean = 0.035;
  EXPECT_NEAR(fitted(lines).circle.radius, 10.003, 1e-5) << "battered by two degrees";
  const CirclePrior whole_wall{0.003, 0.05};  // of a wall that stands farther out above
  EXPECT_NEAR(fitted(lines, whole_wall).circle.radius, 10.003, 1e-4);
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

/// 0.3 mm of a metre in waves of which the longer are the larger (Python: the sum over n of n^-3 (c_n^2 + s_n^2)).
TEST(ShellCircle, OfAnArcLobesAreInTheRadius) {
  EXPECT_NEAR(fitted(linesOf(40, 10.003)).sigma_radius, 0.0312, 0.0005);
  EXPECT_NEAR(fitted(linesOf(76, 10.003)).sigma_radius, 0.0148, 0.0002);
  EXPECT_NEAR(fitted(linesOf(180, 10.003)).sigma_radius, 0.00373, 0.00005);
  EXPECT_NEAR(fitted(linesOf(300, 10.003)).sigma_radius, 0.00068, 0.00001);
}

/// Noise of the lines is no lobe, but for what is left of it in the mean of ten: 5 mm of the radius, and 4.7.
TEST(ShellCircle, NoiseIsNoLobe) {
  const double quiet = fitted(linesOf(76, 10.003)).sigma_radius;
  const double noisy = fitted(linesOf(76, 10.003, 0.003)).sigma_radius;
  EXPECT_NEAR(noisy, std::hypot(quiet, 0.0069), 0.0010);
}

/// Shells out of round by as much as theirs may be: what an arc gives of their radius is within its errors.
TEST(ShellCircle, TheRadiusOfAnArcIsWithinItsError) {
  constexpr int kShells = 300;
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> amplitude(0.1, 2.0);  // of the usual one
  for (const int seen : {76, 120, 200, 300}) {
    int within = 0;
    for (int k = 0; k < kShells; ++k) {
      auto lines = linesOf(seen, 10.003);
      const double usual = amplitude(random) * 0.003;
      for (int n = 2; n <= 8; ++n) {
        const double c = usual * normal(random) / std::pow(n, 1.5), s = usual * normal(random) / std::pow(n, 1.5);
        for (int i = 0; i < seen; ++i)
          lines[static_cast<std::size_t>(i)].radius += c * std::cos(n * i * kDegree) + s * std::sin(n * i * kDegree);
      }
      const ShellCircle round = fitted(lines);
      within += std::abs(round.circle.radius - 10.003) < 2.0 * round.sigma_radius;
    }
    EXPECT_GT(within, 0.94 * kShells) << seen;
  }
}

TEST(ShellCircle, AWholeFootOutweighsTheLocatedCircle) {
  EXPECT_NEAR(fitted(linesOf(360, 10.003, 0.001), {0.005, 0.05}).circle.radius, 10.003, 0.0003);
}

Tank seenOver(double coverage_deg, double rms) {
  Tank tank;
  tank.circle = {{0, 0}, kRadius};
  tank.coverage = coverage_deg * kPi / 180.0;
  tank.rms = rms;
  tank.height = 10.0;
  return tank;
}

TEST(PriorOf, OfAPartOfTheShellHasWhatLobesMakeOfIt) {
  EXPECT_NEAR(priorOf(seenOver(180, 0.0001)).sigma_radius, std::hypot(0.00373, 0.003), 0.00003);
}

TEST(PriorOf, IsNothingForLessThanHalfOfTheShell) {
  EXPECT_TRUE(std::isinf(priorOf(seenOver(170, 0.01)).sigma_radius));
  EXPECT_TRUE(std::isinf(priorOf(seenOver(360, 0.0)).sigma_radius));
  EXPECT_TRUE(std::isinf(priorOf(Tank{}).sigma_center));
}

TEST(PriorOf, KnowsTheRadiusByTheCellsAndTheCentreByTheLean) {
  const CirclePrior prior = priorOf(seenOver(360, 0.012));
  EXPECT_NEAR(prior.sigma_radius, std::hypot(0.002, 3e-4 * kRadius), 1e-9) << "a wall may bulge above its foot";
  EXPECT_NEAR(prior.sigma_center, std::hypot(0.002, 0.05), 1e-9);
}

}  // namespace tank_datum::shell_circle_test
