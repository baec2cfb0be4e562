#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/made_clouds.h"
#include "support/made_shell_lines.h"

/// Lines through a shell that is seen in columns alone.
namespace tank_datum::shell_line_slit_test {

using made_clouds::kTurn;
using made_clouds::uniform;
using namespace made_shell_lines;

/// A shell that is seen all round, but for a degree either side of azimuth 1, where columns alone show it.
struct SlitShell {
  double noise = 0.001;  ///< along the beams [m]
  double slant = 0.0;    ///< how far a beam goes along the shell, to how far it goes out

  ShellLine line(const std::vector<double>& columns) const {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    Points points;
    for (int i = 0; i < 40'000; ++i) {
      const double a = 1.0 + 1.2 * kStep + (kTurn - 2.4 * kStep) * uniform(random),
                   r = kRadius + noise * normal(random);
      points.emplace_back(r * std::cos(a), r * std::sin(a), kReach * uniform(random));
    }
    for (const double t : columns) {
      for (int i = 0; i < 42; ++i) {
        const double off = noise * normal(random), a = 1.0 + (t + slant * off) / kRadius, r = kRadius + off;
        points.emplace_back(r * std::cos(a), r * std::sin(a), 0.06 + 0.01 * i);
      }
    }
    return lineAt(points, 1.0);
  }
};

TEST(FitShellLine, WhatASideAloneDoesNotTellOfTheTurnIsInSigma) {
  const ShellLine line = SlitShell().line({0.1});
  EXPECT_NEAR(line.sigma_radius, std::hypot(0.1 * 0.05, 4.0 * 0.1 * 0.1 / kRadius), 0.001);
  EXPECT_NEAR(line.radius, kRadius, line.sigma_radius);
}

TEST(FitShellLine, WhatTwoSidesDoNotTellOfTheBendIsInSigma) {
  const ShellLine line = SlitShell().line({-0.165, 0.165});
  EXPECT_NEAR(line.sigma_radius, 4.0 * 0.165 * 0.165 / kRadius, 0.002);
  EXPECT_NEAR(line.radius, kRadius, line.sigma_radius);
}

TEST(FitShellLine, AColumnOfSlantingBeamsDoesNotTurnTheShellAlongThem) {
  SlitShell shell;
  shell.slant = 1.0;
  const ShellLine line = shell.line({0.02});
  EXPECT_NEAR(line.radius, kRadius, 0.0025);
  EXPECT_NEAR(line.sigma_radius, 0.001, 0.0003);
}

TEST(FitShellLine, ANoisyShellHasNoTurnThatIsKnownBefore) {
  SlitShell shell;
  const std::vector<double> columns{0.05, 0.1, 0.15};
  shell.noise = 0.004;
  const double known = shell.line(columns).sigma_radius;
  shell.noise = 0.006;
  EXPECT_GT(shell.line(columns).sigma_radius, 1.7 * known);  // as before: 1.5 times
}

}  // namespace tank_datum::shell_line_slit_test
