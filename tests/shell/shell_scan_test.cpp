#include <gtest/gtest.h>

#include <cmath>

#include "support/scanned_tanks.h"
#include "tank_datum/datum.h"

/// The whole chain on a ray-cast scan of a leaning shell out of round, with things that stand in front of it.
namespace tank_datum::shell_scan_test {

using namespace scanned_tanks;

SceneOptions leaningShell() {
  SceneOptions scene = tank20();
  synth::TankOptions& tank = scene.tanks[0];
  tank.height = 5.0;
  tank.out_of_round = {{2, 0.012, radians(50), 1.0}, {3, 0.006, radians(200), -0.5}, {7, 0.002, radians(10), 0.0}};
  tank.lean_x = 0.003, tank.lean_y = -0.004;
  synth::ObjectOptions nozzle, stairs, pipe;
  nozzle.kind = "nozzle", nozzle.azimuth = radians(20), nozzle.z = 0.5, nozzle.radius = 0.2, nozzle.length = 0.25;
  stairs.kind = "stairs", stairs.azimuth = radians(75), stairs.gap = 0.12, stairs.width = 0.8;
  pipe.kind = "pipe_vertical", pipe.azimuth = radians(310), pipe.gap = 0.15, pipe.radius = 0.05, pipe.height = 5.0;
  scene.objects = {nozzle, stairs, pipe};
  scene.scanner.count = 5;
  scene.scanner.step = radians(0.16), scene.scanner.row_step = radians(0.16);
  scene.scanner.min_elevation = radians(-16), scene.scanner.max_elevation = radians(22);
  scene.measurement.range_sigma = 0.0025;
  return scene;
}

struct Run {
  Datum datum;
  synth::TruthTank truth;
};

const Run& run() {
  DatumOptions options;
  options.shell.step = 1.0;  // the truth's
  static const Run made = {extractDatum(Scan::fromPoints(pointsOf(leaningShell())), options), truthOf(leaningShell())};
  return made;
}

TEST(ShellOfAScan, RoundnessIsTheTruthsWithinThreeTenthsOfAMillimetre) {
  ASSERT_TRUE(run().datum.usable()) << run().datum.message;
  const auto& found = run().datum.shell.roundness;
  ASSERT_EQ(found.size(), 5U);
  ASSERT_EQ(run().truth.rounds.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const synth::TruthRound& truth = run().truth.rounds[k];
    EXPECT_DOUBLE_EQ(found[k].height, truth.height);
    EXPECT_NEAR(found[k].max_deviation, truth.max_deviation, 3e-4) << truth.height;
    EXPECT_NEAR(found[k].min_deviation, truth.min_deviation, 3e-4) << truth.height;
    EXPECT_NEAR(found[k].circle.radius, truth.radius, 2e-4) << truth.height;
    EXPECT_GT(found[k].stations, 335U);
  }
}

TEST(ShellOfAScan, PlumbnessAndLeanAreTheTruthsWithinFivePercent) {
  const ShellSurvey& shell = run().datum.shell;
  const synth::TruthPlumb& truth = run().truth.plumb;
  ASSERT_NE(shell.worstPlumbness(), nullptr);
  EXPECT_DOUBLE_EQ(shell.worstPlumbness()->height, truth.height);
  EXPECT_NEAR(std::abs(shell.worstPlumbness()->offset), std::abs(truth.offset), 0.05 * std::abs(truth.offset));
  EXPECT_LT((shell.lean.gradient - run().truth.lean).norm(), 0.05 * run().truth.lean.norm());
  EXPECT_LT((shell.lean.gradient - run().truth.lean).norm(), 3.0 * shell.lean.sigma);
}

TEST(ShellOfAScan, EveryRadiusIsAsGoodAsItsSigmaSays) {
  const synth::Scene scene(leaningShell());
  const Datum& datum = run().datum;
  double within = 0, squares = 0;
  for (const ShellPoint& p : datum.shell.points) {
    const Eigen::Vector3d truth = scene.tank(0).shellPoint(p.azimuth, p.height, false);
    const Eigen::Vector2d centre = datum.circle.center + datum.origin.head<2>();
    const double error = p.radius - (truth.head<2>() - centre).norm();
    within += std::abs(error) < 2.0 * p.sigma;
    squares += error * error;
  }
  const auto count = static_cast<double>(datum.shell.points.size());
  EXPECT_GT(within / count, 0.9);
  EXPECT_LT(std::sqrt(squares / count), 5e-4);
}

TEST(ShellOfAScan, OfAScanThatEndsBelowTheHeightsIsNotSurveyed) {
  SceneOptions scene = tank20();
  scene.near_datum = 0.15;
  const Datum datum = extractDatum(Scan::fromPoints(pointsOf(scene)), {});
  EXPECT_FALSE(datum.shell.valid());
  ASSERT_TRUE(datum.usable()) << datum.message;
  EXPECT_EQ(datum.shell.message, "the scan holds no shell 0.3 m or more above the datum");
}

TEST(ShellOfAScan, InTheTruthATankWithoutShapeIsACircleThatLeansWithItsTilt) {
  SceneOptions scene = tank20();
  const synth::TruthTank truth = truthOf(scene);
  ASSERT_EQ(truth.rounds.size(), 6U);
  for (const synth::TruthRound& r : truth.rounds) {
    EXPECT_NEAR(r.max_deviation, 0.0, 1e-5) << r.height;
    EXPECT_NEAR(r.radius, 10.0, 1e-5);  // round about its axis, cut aslant
  }
  EXPECT_NEAR(truth.plumb.height, 5.0, 1e-12);
  EXPECT_NEAR(std::abs(truth.plumb.offset), 0.005, 1e-5);  // 0.001 over 5 m
  EXPECT_NEAR(truth.lean.norm(), 0.001, 1e-12);
  scene.tanks[0].out_of_round = {{4, 0.02, 0.0, 0.5}};
  EXPECT_NEAR(truthOf(scene).rounds[3].max_deviation, 0.02 * (1.0 + 0.5 * 3.3 / 6.0), 1e-5);
}

}  // namespace tank_datum::shell_scan_test
