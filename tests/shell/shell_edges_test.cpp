#include "shell/shell_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_shells.h"

namespace tank_datum::shell_edges_test {

using namespace made_shells;

constexpr double kFrom = 1.0, kTo = 1.3;  // azimuths of a plate [rad]

/// What a row of a shell with a plate upon it, so thick, says from a direction a metre before it.
struct Seen {
  double runs_on, runs_to_step;  ///< [m]
  double over_edge, over_plate;  ///< steps [m]

  explicit Seen(double thick) {
    MadeShell shell;
    shell.noise = 0.0005, shell.from = 0.2, shell.to = 0.4;
    shell.radius = [=](double a, double) { return kRadius + (a > kFrom && a < kTo ? thick : 0.0); };
    const PolarRing ring(shell.points(), kCentre);
    const ShellOutline outline = outlineBand(ring, kRadius);
    const ShellEdges edges(ring, outline, kRadius);
    const double direction = kFrom - 1.0 / kRadius, widest = 2.0 / kRadius;
    runs_on = kRadius * edges.runsOn(direction, 1, widest);
    runs_to_step = kRadius * edges.runsToStep(direction, 1, widest);
    over_edge = edges.stepsBetween(direction, kFrom + 0.1);
    over_plate = edges.stepsBetween(direction, kTo + 0.1);
  }
};

TEST(ShellEdges, TheShellRunsOnToHalfAColumnBeforeAStep) {
  const Seen seen(0.012);
  EXPECT_NEAR(seen.runs_to_step, 1.0 - 0.0125, 0.004);
  EXPECT_LE(seen.runs_on, seen.runs_to_step);
  EXPECT_NEAR(Seen(0.0).runs_on, 2.0, 1e-9);
}

TEST(ShellEdges, OrToTheMiddleOfTheLastCellBeforeAJump) {
  const Seen seen(0.1);
  EXPECT_LT(seen.runs_on, seen.runs_to_step);
  EXPECT_GT(seen.runs_on, 1.0 - 0.1);
}

TEST(ShellEdges, StepsUpAndDownAgainAddUpToNothing) {
  const Seen seen(0.02);
  EXPECT_NEAR(seen.over_edge, 0.02, 0.001);
  EXPECT_NEAR(seen.over_plate, 0.0, 0.001);
}

}  // namespace tank_datum::shell_edges_test
