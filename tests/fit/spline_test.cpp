#include "fit/spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "support/refused.h"

namespace tank_datum::spline_test {

constexpr double kTurn = 6.283185307179586;
using Wave = std::function<double(double)>;

SplineOptions withControls(int controls, int check_every = 5) {
  SplineOptions options;
  options.control_points = controls;
  options.check_every = check_every;
  return options;
}

double flat(double) { return 1.25; }
double lobes(double a) { return 0.02 * std::cos(2 * a + 0.3) + 0.01 * std::sin(5 * a); }

/// Ordered points round a tank of 10 m radius about (3, -4), z by a wave, with normal errors in all three coordinates.
struct Edge {
  std::vector<double> azimuths;
  std::vector<Eigen::Vector3d> points;

  static Eigen::Vector3d truth(double a, const Wave& wave) {
    return {3.0 + 10.0 * std::cos(a), -4.0 + 10.0 * std::sin(a), wave(a)};
  }
  Edge(std::size_t count, const Wave& wave, double noise = 0.0, double from = 0.0, double to = kTurn) {
    std::mt19937 random(1);
    std::normal_distribution<double> error(0.0, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
      azimuths.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
      points.push_back(truth(azimuths.back(), wave));
      if (noise > 0) points.back() += noise * Eigen::Vector3d(error(random), error(random), error(random));
    }
  }
  ClosedSpline fit(const SplineOptions& options) const { return fitClosedSpline(points, azimuths, options); }
};

/// Largest distance of the curve from the truth at the same azimuth [m].
double worstError(const ClosedSpline& curve, const Wave& wave) {
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = kTurn * (i + 0.37) / 1000;
    worst = std::max(worst, (curve.at(a) - Edge::truth(a, wave)).norm());
  }
  return worst;
}

bool sameControls(const ClosedSpline& a, const ClosedSpline& b) {
  return a.control_points.rows() == b.control_points.rows() && a.control_points == b.control_points;
}

TEST(CubicBasis, SumsToOneEverywhere) {
  for (double t = 0; t <= 1.0; t += 0.05) EXPECT_NEAR(cubicBasis(t).sum(), 1.0, 1e-15) << t;
}

TEST(CubicBasis, HasItsKnownValuesAtTheKnots) {
  EXPECT_TRUE(cubicBasis(0).isApprox(Eigen::Vector4d(1, 4, 1, 0) / 6));
  EXPECT_TRUE(cubicBasis(0.5).isApprox(Eigen::Vector4d(1, 23, 23, 1) / 48));
  EXPECT_TRUE(cubicBasis(1).isApprox(Eigen::Vector4d(0, 1, 4, 1) / 6));
}

TEST(CubicBasis, AsPrintedInThePaperDoesNotSumToOne) {
  const double t = 0.5;
  Eigen::Vector4d printed = cubicBasis(t);
  printed[1] = (4 - 6 * t * t - 3 * t * t * t) / 6;  // the paper's G1
  EXPECT_NEAR(printed.sum(), 1.0 - t * t * t, 1e-15);
}

TEST(ClosedSpline, IsNotValidUntilFitted) { EXPECT_FALSE(ClosedSpline().valid()); }

TEST(FitClosedSpline, NeedsTwelvePoints) {
  EXPECT_FALSE(fitClosedSpline({}, {}, {}).valid());
  EXPECT_FALSE(Edge(11, flat).fit({}).valid());
  EXPECT_TRUE(Edge(12, flat).fit({}).valid());
}

TEST(FitClosedSpline, ReproducesAConstant) {
  for (const int controls : {4, 7, 36}) {
    const ClosedSpline curve = Edge(200, flat).fit(withControls(controls));
    ASSERT_EQ(curve.control_points.rows(), controls);
    for (double a = -1; a < 8; a += 0.1) EXPECT_NEAR(curve.at(a).z(), 1.25, 1e-12) << controls;
  }
}

TEST(FitClosedSpline, ReproducesACircleAndKnownWaves) {
  EXPECT_LT(worstError(Edge(3600, flat).fit(withControls(90)), flat), 5e-6 * 10);
  EXPECT_LT(worstError(Edge(3600, flat).fit(withControls(180)), flat), 1e-6);
  const ClosedSpline curve = Edge(3600, lobes).fit(withControls(120));
  for (double a = 0; a < kTurn; a += 0.01) EXPECT_NEAR(curve.at(a).z(), lobes(a), 1e-6);
}

TEST(FitClosedSpline, ErrorFallsWithTheFourthPowerOfTheSpan) {
  const Edge edge(3600, lobes);
  const double coarse = worstError(edge.fit(withControls(24)), lobes),
               fine = worstError(edge.fit(withControls(48)), lobes);
  EXPECT_GT(coarse, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

TEST(FitClosedSpline, IsClosedAndSmoothToTheSecondDerivativeAtTheSeam) {
  const ClosedSpline curve = Edge(400, lobes, 0.01).fit(withControls(12));
  const double h = 1e-4;
  for (int component = 0; component < 3; ++component) {
    const auto at = [&](double a) { return curve.at(a)[component]; };
    EXPECT_NEAR(at(-1e-9), at(1e-9), 1e-7);
    const double before = (at(0) - at(-h)) / h, after = (at(h) - at(0)) / h;
    EXPECT_NEAR(before, after, 30 * h);
    const double bend_before = (at(0) - 2 * at(-h) + at(-2 * h)) / (h * h);
    const double bend_after = (at(0) - 2 * at(h) + at(2 * h)) / (h * h);
    EXPECT_NEAR(bend_before, bend_after, 0.02) << component;
  }
}

TEST(ClosedSpline, TakesAnyAzimuth) {
  const ClosedSpline curve = Edge(400, lobes).fit(withControls(24));
  for (double a = 0.05; a < kTurn; a += 0.1) {
    EXPECT_LT((curve.at(a + kTurn) - curve.at(a)).norm(), 1e-12);
    EXPECT_LT((curve.at(a - 2 * kTurn) - curve.at(a)).norm(), 1e-12);
  }
}

TEST(ClosedSpline, DistanceIsThatOfTheNearestPlaceNotOfTheSameAzimuth) {
  const ClosedSpline curve = Edge(3600, flat).fit(withControls(90));
  const Eigen::Vector3d on = Edge::truth(1.0, flat);
  EXPECT_NEAR(curve.distance(on, 1.0), 0.0, 1e-5);
  EXPECT_NEAR(curve.distance(on, 1.03), 0.0, 1e-5);  // 0.3 m along the shell
  EXPECT_NEAR(curve.distance(on + Eigen::Vector3d(0, 0, 0.2), 1.0), 0.2, 1e-5);
  EXPECT_NEAR(curve.distance({3.0 + 10.5 * std::cos(1.0), -4.0 + 10.5 * std::sin(1.0), 1.25}, 1.02), 0.5, 1e-5);
}

TEST(FitClosedSpline, CheckPointsMoveNothing) {
  for (const int controls : {24, 0}) {
    Edge edge(500, lobes, 0.002);
    const ClosedSpline before = edge.fit(withControls(controls));
    edge.points[100].z() += 0.5;  // every fifth checks
    const ClosedSpline after = edge.fit(withControls(controls));
    EXPECT_TRUE(sameControls(before, after));
    EXPECT_LT(before.max_residual, 0.02);
    EXPECT_NEAR(after.max_residual, 0.5, 0.02);
    EXPECT_NEAR(after.rms * after.rms - before.rms * before.rms, 0.25 / 100, 2e-4);
    edge.points[101].z() += 0.5;
    EXPECT_FALSE(sameControls(edge.fit(withControls(controls)), before));
  }
}

TEST(FitClosedSpline, CheckEveryDecidesHowManyCheck) {
  const Edge edge(100, lobes, 0.002);
  EXPECT_EQ(edge.fit(withControls(12, 5)).check_points, 20U);
  EXPECT_EQ(edge.fit(withControls(12, 2)).check_points, 50U);
  EXPECT_FALSE(sameControls(edge.fit(withControls(12, 5)), edge.fit(withControls(12, 2))));
}

TEST(FitClosedSpline, RmsIsThatOfTheNoiseAcrossTheCurve) {
  const ClosedSpline curve = Edge(20'000, lobes, 0.003).fit(withControls(24));
  EXPECT_NEAR(curve.rms, 0.003 * std::sqrt(2.0), 0.0002);  // two directions across, none along
  EXPECT_LT(curve.max_residual, 0.003 * 5.5);
}

TEST(FitClosedSpline, ChosenControlPointsGrowWithStructure) {
  const auto chosen = [](const Wave& wave) { return Edge(3600, wave, 0.002).fit({}).control_points.rows(); };
  const auto quiet = chosen(flat);
  const auto lobed = chosen([](double a) { return 0.02 * std::cos(12 * a); });
  const auto rough = chosen([](double a) { return 0.02 * std::cos(24 * a + 0.8); });
  EXPECT_LT(quiet, lobed);
  EXPECT_LT(lobed, rough);
  EXPECT_GT(rough, 48);  // two per wave and more
}

TEST(FitClosedSpline, ChosenControlPointsDoNotGrowWithNoise) {
  const auto chosen = [](double noise) { return Edge(3600, lobes, noise).fit({}).control_points.rows(); };
  EXPECT_LE(chosen(0.01), chosen(0.002));
  EXPECT_LE(chosen(0.05), chosen(0.01));
  EXPECT_LE(chosen(0.05), 12);
}

TEST(FitClosedSpline, BridgesAGapOfThirtyDegrees) {
  const Edge edge(1000, flat, 0.0, 0.5, 0.5 + kTurn * 330 / 360);
  for (const int controls : {72, 0}) {
    const ClosedSpline curve = edge.fit(withControls(controls));
    for (double a = 0.5 - kTurn / 12; a < 0.5; a += 0.01) {
      EXPECT_NEAR(curve.at(a).z(), 1.25, 1e-6) << a;
      EXPECT_LT((curve.at(a) - Edge::truth(a, flat)).norm(), 0.01) << a;
    }
  }
}

TEST(SplineOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(SplineOptions())), "");
  EXPECT_EQ(said(firstError(withControls(4))), "");
  EXPECT_EQ(said(firstError(withControls(1000, 2))), "");
  EXPECT_EQ(said(firstError(withControls(3))), "control_points, 3, expected 0 or 4 to 1000");
  EXPECT_EQ(said(firstError(withControls(1001))), "control_points, 1001, expected 0 or 4 to 1000");
  EXPECT_NE(said(firstError(withControls(-4))), "");
  EXPECT_EQ(said(firstError(withControls(0, 1))), "spline.check_every, 1, expected >= 2");
  EXPECT_NE(said(firstError(withControls(0, 0))), "");
}

}  // namespace tank_datum::spline_test
