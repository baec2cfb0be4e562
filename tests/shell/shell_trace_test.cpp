#include "shell/shell_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
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

  std::optional<std::vector<ShellCell>> trace(std::size_t steps = 2, double usual = 0.001) const {
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
  ASSERT_TRUE(trace.has_value());
  ASSERT_EQ(trace->size(), 1U);
  EXPECT_NEAR(trace->at(0).radius, kRadius + 0.3 * 0.15, 0.006);  // the mean of 50 mm of it
  EXPECT_GT(trace->at(0).points, 40U);
  EXPECT_LT(trace->at(0).sigma, 0.001);
}

TEST(TraceShell, ADentRunsOn) {
  Band band;
  band.off = peak(-0.3);
  EXPECT_TRUE(band.trace().has_value());
}

TEST(TraceShell, EveryStationBetweenIsTraced) {
  Band band;
  band.off = [](double t) { return 0.2 * t; };
  const auto trace = band.trace(4);
  ASSERT_TRUE(trace.has_value());
  ASSERT_EQ(trace->size(), 3U);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(trace->at(static_cast<std::size_t>(i)).radius, kRadius + 0.2 * 0.2 * (i - 1), 0.002);
  const auto next = band.trace(1);
  ASSERT_TRUE(next.has_value());
  EXPECT_TRUE(next->empty());
}

TEST(TraceShell, TheSteepestTurnsByFourTenths) {
  Band band;
  band.noise = 0.0001;
  band.off = peak(0.37);
  EXPECT_TRUE(band.trace(2, 0.0001).has_value());
  band.off = peak(0.6);
  EXPECT_FALSE(band.trace(2, 0.0001).has_value());
}

TEST(TraceShell, WhatStandsBeforeItBeginsWithAJump) {
  Band band;
  band.off = [](double t) { return std::abs(t) < 0.1 ? 0.05 : 0.0; };
  EXPECT_FALSE(band.trace().has_value());
}

TEST(TraceShell, NorIsItTheShellThatLiesOffItAtItsEnds) {
  Band band;
  band.ends_off = 0.015;
  EXPECT_TRUE(band.trace().has_value());
  band.ends_off = -0.03;
  EXPECT_FALSE(band.trace().has_value());
}

TEST(TraceShell, NorIsASheetAcrossTheEdgeOfOne) {
  Band band;
  for (const double high : {0.05, 0.12}) {
    band.off = [high](double t) { return std::clamp(t, 0.0, high); };
    EXPECT_FALSE(band.trace().has_value()) << high;
  }
}

TEST(TraceShell, NorARoundBodySunkInIt) {
  Band band;
  band.off = [](double t) { return std::max(0.0, std::sqrt(std::max(0.0, 0.25 - t * t)) - 0.4); };
  EXPECT_FALSE(band.trace(4).has_value());
}

TEST(TraceShell, NoiseOfMoreThanTenMillimetresHidesJumps) {
  Band band;
  EXPECT_TRUE(band.trace(2, 0.0095).has_value());
  EXPECT_FALSE(band.trace(2, 0.0105).has_value());
}

TEST(TraceShell, AJumpIsToldFromErrors) {
  Band band;
  band.noise = 0.008, band.count = 800;
  const auto step = [&](double high) {
    band.off = [high](double t) { return t < 0.025 ? 0.0 : high; };
    return band.trace(2, 0.008).has_value();
  };
  EXPECT_TRUE(step(0.026));
  EXPECT_FALSE(step(0.035));
}

TEST(TraceShell, SeveralThingsAtOnceAreNoShell) {
  Band band;
  band.off = [](double t) { return std::fmod(std::abs(t) * 1e4, 1.0) < 0.5 ? 0.0 : 0.06; };
  EXPECT_FALSE(band.trace().has_value());
}

TEST(TraceShell, PointsThatScatterTwiceAsUsualAreTheShellYet) {
  Band band;
  band.noise = 0.030, band.count = 40'000;
  EXPECT_TRUE(band.trace(2, 0.0075).has_value());  // 15 mm, and 20 that a column may turn by
  EXPECT_FALSE(band.trace(2, 0.0040).has_value());
}

TEST(TraceShell, AColumnOfFiftyMillimetresMayBeEmptyTwoMayNot) {
  Band band;
  const auto hole = [&](double wide) {
    band.seen = [wide](double t) { return !(t > 0.025 && t < 0.025 + wide); };
    return band.trace();
  };
  ASSERT_TRUE(hole(0.05).has_value());
  EXPECT_FALSE(hole(0.11).has_value());
}

TEST(TraceShell, AColumnNeedsFivePoints) {
  Band band;
  band.count = 400;  // 10 of a column at the height
  EXPECT_TRUE(band.trace().has_value());
  band.count = 100;
  EXPECT_FALSE(band.trace().has_value());
}

}  // namespace tank_datum::shell_trace_test
