#include "foot/shell_bends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/units.h"

namespace tank_datum::shell_bends_test {

constexpr double kRadius = 10.0, kReach = 0.5, kStep = kTwoPi / 360.0;
constexpr int kStation = 180;

/// What is seen of a shell about a station, of which lines 10 m from the axis have been fitted all round.
struct Bent {
  std::function<double(double)> off;                               ///< of the shell from the lines by its height [m]
  std::function<bool(double)> seen = [](double) { return true; };  ///< by its height
  int count = 4000;                                                ///< points over the reach, of five stations
  double noise = 0.001;                                            ///< [m]
  double line_noise = 0.005;                                       ///< of the lines, which bends make larger [m]
  double nearest = 0.0;                                            ///< steps to either side that are not seen
  std::size_t line_points = 100;                                   ///< that each line was fitted to
  double sigma_along = 0.0;                                        ///< what turn and bend leave of their radii [m]

  ShellLine line() const {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, noise);
    Points points;
    for (int i = 0; i < count; ++i) {
      const double h = kReach * (i + 0.5) / count, turn = 4.8 * (std::fmod(0.618034 * i, 1.0) - 0.5);
      const double a = (kStation + turn) * kStep, r = kRadius + off(h) + normal(random);
      if (seen(h) && std::abs(turn) >= nearest) points.emplace_back(r * std::cos(a), r * std::sin(a), h);
    }
    std::vector<ShellLine> lines(360);
    std::vector<ShellWindow> windows;
    for (int i = 0; i < 360; ++i) {
      ShellLine& line = lines[static_cast<std::size_t>(i)];
      line.radius = kRadius, line.sigma_radius = 0.0002, line.noise = line_noise, line.straight_to = kReach;
      line.points = line_points, line.sigma_along = sigma_along;
      windows.push_back({i * kStep, kStep, 0.0, {0.05, kReach}});
    }
    return linesAtFoot(PolarRing(points, {0.0, 0.0}), lines, windows)[kStation];
  }
  /// How far the shell is off the line at the foot [m].
  double atFoot() const { return line().radius - kRadius; }
};

/// As of a shell that is off its line by so much at the foot, and by nothing from a height on.
std::function<double(double)> bentBelow(double height, double at_foot) {
  return [=](double h) { return h < height ? at_foot * (1.0 - h / height) : 0.0; };
}

TEST(LinesAtFoot, OfAStraightShellAreWhatTheyWere) {
  const ShellLine line = Bent{[](double) { return 0.0; }}.line();
  EXPECT_EQ(line.radius, kRadius);
  EXPECT_EQ(line.noise, 0.005);
  EXPECT_EQ(line.straight_to, kReach);
}

TEST(LinesAtFoot, OfAShellThatBendsAreOfItsStraightPart) {
  for (const double off : {-0.015, 0.015}) {
    const ShellLine line = Bent{bentBelow(0.3, off)}.line();
    EXPECT_NEAR(line.radius, kRadius + off, 4.0 * line.sigma_radius);
    EXPECT_NEAR(line.lean, -off / 0.3, 0.002);
    EXPECT_NEAR(line.straight_to, 0.3, 1e-9);
    EXPECT_NEAR(line.noise, 0.001, 0.0002);
    EXPECT_LT(line.sigma_radius, 0.0002);
  }
}

TEST(LinesAtFoot, AreNoSurerThanTurnAndBendLeaveTheirRadii) {
  Bent bent{bentBelow(0.3, -0.015)};
  bent.sigma_along = 0.004;
  EXPECT_NEAR(bent.line().sigma_radius, 0.004, 0.0001);
}

TEST(LinesAtFoot, AFifthOfTheReachIsBentAtTheLowest) {
  EXPECT_NEAR((Bent{bentBelow(0.12, -0.010)}).atFoot(), -0.010, 0.0006);
  EXPECT_NEAR((Bent{bentBelow(0.12, -0.010)}).line().straight_to, 0.108, 1e-9);
}

TEST(LinesAtFoot, ASheetThatSlopesOutOfTheShellIsNoBendOfIt) {  // seen from above, and nothing of the shell under it
  const auto drip_ring = [](double h) { return h < 0.11 ? 0.15 * (0.11 - h) : 0.0; };
  const auto above = [](double h) { return h > 0.095; };
  EXPECT_NEAR((Bent{drip_ring, above}).atFoot(), 0.0, 0.003);
}

TEST(LinesAtFoot, TheLowestTwentiethOfTheReachIsTheWelds) {
  const auto bent = bentBelow(0.3, -0.015);
  const auto weld = [&](double h) { return bent(h) + (h > 0.013 && h < 0.024 ? 0.003 : 0.0); };
  EXPECT_NEAR((Bent{weld}).atFoot(), -0.015, 0.0003);
  const auto low = [](double h) { return h < 0.047 || h > 0.3; };
  EXPECT_NEAR((Bent{bentBelow(0.2, -0.015), low}).atFoot(), -0.015, 0.002);
}

/// A shell bent by 10 mm before which something stands, over most of what is seen up to a height.
std::function<double(double)> behind(double before, double height) {
  return [=](double h) {
    const bool hidden = h < height && std::fmod(h * 997.0, 1.0) < 0.7;
    return bentBelow(0.3, -0.010)(h) + (hidden ? before : 0.0);
  };
}

TEST(LinesAtFoot, WhatStandsSixNoisesBeforeTheShellIsAnotherThing) {
  EXPECT_NEAR((Bent{behind(0.045, 0.25)}).atFoot(), -0.010, 0.0005);
}

TEST(LinesAtFoot, WhatStandsAFifthOfTheReachBeforeTheShellIsAnotherThing) {
  Bent bent{behind(0.150, 0.2)};
  bent.line_noise = 0.04;
  EXPECT_NEAR(bent.atFoot(), -0.010, 0.0005);
}

TEST(LinesAtFoot, BendsWithinFourStandardErrorsAreNone) {
  const auto bent = [](double off) { return Bent{bentBelow(0.3, off), [](double) { return true; }, 400}; };
  EXPECT_EQ(bent(-0.0007).atFoot(), 0.0);
  EXPECT_LT(bent(-0.0015).atFoot(), -0.001);
}

TEST(LinesAtFoot, TwelvePointsAreTheFewest) {
  const auto few = [](int points) {
    const double lowest = 0.025, part = 0.3 - lowest;
    const int count = static_cast<int>(points * kReach / part);
    return Bent{bentBelow(0.3, -0.010), [](double) { return true; }, count, 0.0002}.atFoot();
  };
  EXPECT_EQ(few(9), 0.0);
  EXPECT_LT(few(16), -0.008);
}

TEST(LinesAtFoot, TwoAndAHalfWindowsAreLookedAt) {
  Bent bent{bentBelow(0.3, -0.010)};
  bent.nearest = 1.4;
  EXPECT_NEAR(bent.atFoot(), -0.010, 0.0005);
}

TEST(LinesAtFoot, AShellWhoseNoiseHidesBendsKeepsItsLines) {
  const auto noisy = [](double noise) {
    Bent bent{bentBelow(0.3, -0.027)};
    bent.noise = noise, bent.line_noise = 0.015;
    return bent.atFoot();
  };
  EXPECT_LT(noisy(0.0042), -0.023);
  EXPECT_EQ(noisy(0.0060), 0.0);
}

TEST(LinesAtFoot, AreFittedToSixHundredPoints) {
  Bent few{bentBelow(0.3, 0.015)}, many = few;
  few.count = 600;
  many.count = 40'000, many.line_points = 16'000;
  EXPECT_NEAR(many.line().sigma_radius, few.line().sigma_radius, 0.2 * few.line().sigma_radius);
}

}  // namespace tank_datum::shell_bends_test
