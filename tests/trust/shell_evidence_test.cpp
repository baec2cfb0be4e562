#include "trust/shell_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/units.h"

namespace tank_datum::shell_evidence_test {

constexpr double kRadius = 5.0;

Tank tankOf(double radius = kRadius) {
  Tank tank;
  tank.circle = {{1.0, -2.0}, radius};
  tank.foot.coefficients = Eigen::Vector3d(0.25, 0.0, 0.0);
  tank.resolution = 0.01 * radius;
  return tank;
}

/// A wall of 40 points a square decimetre, over an arc; its radius by azimuth and height above the foot.
Ring wallOf(const Tank& tank, const std::function<double(double, double)>& radius, double noise = 0.001,
            double arc = kTwoPi) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, noise);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Ring ring;
  ring.reach = 0.5;
  const auto count = static_cast<int>(4000.0 * 0.5 * arc * tank.circle.radius);
  for (int i = 0; i < count; ++i) {
    const double a = arc * uniform(random), h = 0.5 * uniform(random), r = radius(a, h) + normal(random);
    ring.points.emplace_back(tank.circle.center.x() + r * std::cos(a), tank.circle.center.y() + r * std::sin(a),
                             0.25 + h);
  }
  return ring;
}

TEST(ShellEvidence, OfNothingIsNotKnown) {
  EXPECT_FALSE(lookAtShell(Ring(), tankOf()).known());
  EXPECT_FALSE(lookAtShell(Ring(), tankOf()).lean.known());
}

TEST(ShellEvidence, OfARoundShell) {
  const Tank tank = tankOf();
  const ShellEvidence shell = lookAtShell(wallOf(tank, [](double, double) { return kRadius; }), tank);
  ASSERT_TRUE(shell.known());
  EXPECT_NEAR(shell.circle.radius, kRadius, 1e-4);
  EXPECT_NEAR(shell.noise, 0.001, 0.0002);
  EXPECT_NEAR(shell.spacing, 1.0 / std::sqrt(4000.0), 0.002);
  EXPECT_LT(shell.off_round, 0.0005);
  EXPECT_EQ(shell.on_circle, 1.0);
  EXPECT_LT(shell.sigma_radius, 1e-4);
  EXPECT_NEAR(shell.cone, 0.0, 4.0 * shell.sigma_cone);
  EXPECT_LT(shell.lean.slope.norm(), 4.0 * shell.lean.sigma);
}

TEST(ShellEvidence, OutOfRoundnessIsARobustStandardDeviation) {
  const Tank tank = tankOf();
  const ShellEvidence shell =
      lookAtShell(wallOf(tank, [](double a, double) { return kRadius + 0.05 * std::cos(2 * a); }), tank);
  EXPECT_NEAR(shell.off_round, 0.05 * 1.4826 / std::sqrt(2.0), 0.002);
  EXPECT_EQ(shell.on_circle, 1.0);  // 2.5 times 0.4 % of the radius are 50 mm
}

TEST(ShellEvidence, ASquareIsOffItsCircle) {
  const Tank tank = tankOf();
  const auto square = [](double a, double) {
    return 0.93 * kRadius / std::max(std::abs(std::cos(a)), std::abs(std::sin(a)));
  };
  const ShellEvidence shell = lookAtShell(wallOf(tank, square), tank);
  EXPECT_GT(shell.off_round, 0.03 * kRadius);
  EXPECT_LT(shell.on_circle, 0.5);
}

TEST(ShellEvidence, AShortArcKnowsItsRadiusBadly) {
  const Tank tank = tankOf();
  const auto wavy = [](double a, double) { return kRadius + 0.02 * std::cos(40 * a); };
  const double whole = lookAtShell(wallOf(tank, wavy), tank).sigma_radius;
  const double arc = lookAtShell(wallOf(tank, wavy, 0.001, 0.8), tank).sigma_radius;
  EXPECT_GT(arc, 50.0 * whole);
}

TEST(ShellEvidence, LeanAndConeAreToldApart) {
  const Tank tank = tankOf();
  const Eigen::Vector2d slope(0.02, -0.01);
  const ShellEvidence shell = lookAtShell(
      wallOf(tank, [&](double a,
                       double h) { return kRadius + h * (0.15 + slope.x() * std::cos(a) + slope.y() * std::sin(a)); }),
      tank);
  EXPECT_NEAR(shell.cone, 0.15, 0.005);
  ASSERT_TRUE(shell.lean.known());
  EXPECT_LT((shell.lean.slope - slope).norm(), 4.0 * shell.lean.sigma);
  EXPECT_LT(shell.lean.sigma, 0.002);
  EXPECT_LT((shell.lean.axis() - Eigen::Vector3d(0.02, -0.01, 1.0).normalized()).norm(), 0.005);
}

TEST(ShellEvidence, OfALeaningShellHasTheCircleOfItsFoot) {
  const Tank tank = tankOf();
  const auto leans = [](double a, double h) { return kRadius + 0.03 * h * std::cos(a); };
  const ShellEvidence shell = lookAtShell(wallOf(tank, leans), tank);
  EXPECT_LT((shell.at_foot.center - tank.circle.center).norm(), 0.0005);
  EXPECT_GT((shell.circle.center - tank.circle.center).norm(), 0.006);  // of half a ring's height
  EXPECT_EQ(shell.at_foot.radius, shell.circle.radius);
}

TEST(ShellEvidence, DoesNotDependOnTheUnit) {
  const Tank tank = tankOf();
  const auto lobes = [](double a, double) { return kRadius + 0.03 * std::cos(3 * a); };
  Ring ring = wallOf(tank, lobes);
  const ShellEvidence once = lookAtShell(ring, tank);
  Tank thousandfold = tank;
  thousandfold.circle = {1000.0 * tank.circle.center, 1000.0 * kRadius};
  thousandfold.foot.coefficients *= 1000.0;
  ring.reach *= 1000.0;
  for (Eigen::Vector3d& p : ring.points) p *= 1000.0;
  const ShellEvidence again = lookAtShell(ring, thousandfold);
  EXPECT_NEAR(again.off_round, 1000.0 * once.off_round, 1e-6);
  EXPECT_NEAR(again.noise, 1000.0 * once.noise, 1e-6);
  EXPECT_NEAR(again.cone, once.cone, 1e-9);
}

}  // namespace tank_datum::shell_evidence_test
