#include "shell/shell_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/made_clouds.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::shell_trace_test {

constexpr double kRadius = 10.0, kStep = 0.02;  // rad: 0.2 m

/// A band of the shell about azimuth 0, by how far it is off its circle against the arc [m].
struct Band {
  std::function<double(double)> off = [](double) { return 0.0; };
  std::function<bool(double)> seen = [](double) { return true; };
  double noise = 0.001;
  int count = 4000;       // of a metre
  double ends_off = 0.0;  ///< the shell at the ends from the points there

  ShellTrace trace(std::size_t steps = 2, double usual = 0.001) const {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Points points;
    for (int i = 0; i < count; ++i) {
      const double t = made_clouds::uniform(random) - 0.5;
      if (!seen(t)) continue;
      const double a = t / kRadius, r = kRadius + off(t) + noise * normal(random);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 5.0 + 0.4 * (made_clouds::uniform(random) - 0.5));
    }
    const double half = 0.5 * kStep * static_cast<double>(steps);
    const auto end = [&](double turn) { return ShellCell{kRadius + off(turn * kRadius) + ends_off, 0.0005, 1.0, 100}; };
    return traceShell(PolarRing(points, {0.0, 0.0}),
                      {-half, half, 5.0, 5.0, 0.1, kRadius, usual, steps, end(-half), end(half)});
  }
};

/// A peaked weld: so high over a metre.
std::function<double(double)> peak(double slope) {
  return [slope](double t) { return std::max(0.0, slope * (0.15 - std::abs(t))); };
}

TEST(TraceShell, APeakedWeldRunsOn) {
  Band band;
  band.off = peak(0.3);
  const auto trace = band.trace();
  ASSERT_TRUE(trace.runs_on);
  ASSERT_EQ(trace.stations.size(), 1U);
  EXPECT_NEAR(trace.stations.at(0).radius, kRadius + 0.3 * 0.15, 0.006);  // the mean of 50 mm of it
  EXPECT_GT(trace.stations.at(0).points, 40U);
  EXPECT_LT(trace.stations.at(0).sigma, 0.001);
}

TEST(TraceShell, ADentRunsOn) {
  Band band;
  band.off = peak(-0.3);
  EXPECT_TRUE(band.trace().runs_on);
}

TEST(TraceShell, EveryStationBetweenIsTraced) {
  Band band;
  band.off = [](double t) { return 0.2 * t; };
  const auto trace = band.trace(4);
  ASSERT_TRUE(trace.runs_on);
  ASSERT_EQ(trace.stations.size(), 3U);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(trace.stations.at(static_cast<std::size_t>(i)).radius, kRadius + 0.2 * 0.2 * (i - 1), 0.002);
  const auto next = band.trace(1);
  ASSERT_TRUE(next.runs_on);
  EXPECT_TRUE(next.stations.empty());
}

TEST(TraceShell, TheSteepestTurnsByFourTenths) {
  Band band;
  band.noise = 0.0001;
  band.off = peak(0.37);
  EXPECT_TRUE(band.trace(2, 0.0001).runs_on);
  band.off = peak(0.6);
  EXPECT_FALSE(band.trace(2, 0.0001).runs_on);
}

TEST(TraceShell, WhatStandsBeforeItBeginsWithAJump) {
  Band band;
  band.off = [](double t) { return std::abs(t) < 0.1 ? 0.05 : 0.0; };
  EXPECT_FALSE(band.trace().runs_on);
}

TEST(TraceShell, AStepIsNoTurnHoweverLow) {
  Band band;
  band.off = [](double t) { return t < 0.012 ? 0.0 : 0.018; };
  EXPECT_FALSE(band.trace().runs_on);
  EXPECT_NEAR(band.trace().stepped, 0.018, 0.001);
  band.off = [](double t) { return t < 0.0 ? 0.0 : std::min(0.018, 0.2 * t); };
  EXPECT_TRUE(band.trace().runs_on);
  EXPECT_EQ(band.trace().stepped, 0.0);
}

TEST(TraceShell, AStepMayShowItsEdge) {
  Band band;
  band.off = [](double t) { return t < 0.0 ? 0.0 : std::min(0.03, 6.0 * t); };
  EXPECT_FALSE(band.trace().runs_on);
  EXPECT_NEAR(band.trace().stepped, 0.03, 0.002);
}

TEST(TraceShell, StepsUpAndDownAgainAddUpToNothing) {
  Band band;
  band.off = [](double t) { return std::abs(t) < 0.06 ? 0.1 : 0.0; };
  EXPECT_FALSE(band.trace(4).runs_on);
  EXPECT_NEAR(band.trace(4).stepped, 0.0, 0.001);
}

TEST(TraceShell, NorIsItTheShellThatLiesOffItAtItsEnds) {
  Band band;
  band.ends_off = 0.015;
  EXPECT_TRUE(band.trace().runs_on);
  band.ends_off = -0.03;
  EXPECT_FALSE(band.trace().runs_on);
}

TEST(TraceShell, NorIsASheetAcrossTheEdgeOfOne) {
  Band band;
  for (const double high : {0.05, 0.12}) {
    band.off = [high](double t) { return std::clamp(t, 0.0, high); };
    EXPECT_FALSE(band.trace().runs_on) << high;
  }
}

TEST(TraceShell, NorARoundBodySunkInIt) {
  Band band;
  band.off = [](double t) { return std::max(0.0, std::sqrt(std::max(0.0, 0.25 - t * t)) - 0.4); };
  EXPECT_FALSE(band.trace(4).runs_on);
}

TEST(TraceShell, NoiseOfMoreThanTenMillimetresHidesJumps) {
  Band band;
  EXPECT_TRUE(band.trace(2, 0.0095).runs_on);
  EXPECT_FALSE(band.trace(2, 0.0105).runs_on);
}

TEST(TraceShell, AJumpIsToldFromErrors) {
  Band band;
  band.noise = 0.008, band.count = 800;
  const auto turn = [&](double of_a_column) {
    band.off = [of_a_column](double t) { return of_a_column / 0.05 * t; };
    return band.trace(2, 0.008).runs_on;
  };
  EXPECT_TRUE(turn(0.026));
  EXPECT_FALSE(turn(0.036));
}

TEST(TraceShell, SeveralThingsAtOnceAreNoShell) {
  Band band;
  band.off = [](double t) { return std::fmod(std::abs(t) * 1e4, 1.0) < 0.5 ? 0.0 : 0.06; };
  EXPECT_FALSE(band.trace().runs_on);
}

TEST(TraceShell, PointsThatScatterTwiceAsUsualAreTheShellYet) {
  Band band;
  band.noise = 0.030, band.count = 40'000;
  EXPECT_TRUE(band.trace(2, 0.0075).runs_on);  // 15 mm, and 20 that a column may turn by
  EXPECT_FALSE(band.trace(2, 0.0040).runs_on);
}

TEST(TraceShell, AColumnOfFiftyMillimetresMayBeEmptyTwoMayNot) {
  Band band;
  const auto hole = [&](double wide) {
    band.seen = [wide](double t) { return !(t > 0.025 && t < 0.025 + wide); };
    return band.trace();
  };
  ASSERT_TRUE(hole(0.05).runs_on);
  EXPECT_FALSE(hole(0.11).runs_on);
}

TEST(TraceShell, AColumnNeedsFivePoints) {
  Band band;
  band.count = 400;  // 10 of a column at the height
  EXPECT_TRUE(band.trace().runs_on);
  band.count = 100;
  EXPECT_FALSE(band.trace().runs_on);
}

}  // namespace tank_datum::shell_trace_test
