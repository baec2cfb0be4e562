#include "fit/curve_comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refused.h"
#include "tank_datum/core/error.h"

namespace tank_datum::curve_comparison_test {

constexpr CurveKind kAll[] = {CurveKind::Lagrange, CurveKind::Bezier, CurveKind::Polynomial, CurveKind::BSpline};
constexpr CurveKind kThroughPoints[] = {CurveKind::Lagrange, CurveKind::BSpline};

double cubic(double t) { return 1.0 + 0.5 * t - 0.25 * t * t + 0.03 * t * t * t; }
double line(double t) { return 2.0 - 0.001 * t; }
double runge(double t) { return 1.0 / (1.0 + 25.0 * t * t); }

LinePoints sampled(double from, double to, int count, double (*f)(double)) {
  LinePoints points;
  for (int i = 0; i < count; ++i) {
    const double t = from + (to - from) * i / (count - 1);
    points.emplace_back(t, f(t));
  }
  return points;
}

CurveOptions withPoints(int points, int degree = 3) {
  CurveOptions options;
  options.points = points;
  options.degree = degree;
  return options;
}

CurveFigures figuresOf(CurveKind kind, const LinePoints& points, const CurveOptions& options) {
  return compareCurves(points, options).at(static_cast<std::size_t>(kind));
}

TEST(FitCurve, EveryCurveOfPointsOnALineIsTheLine) {
  const LinePoints uneven = {{0, line(0)}, {1, line(1)}, {3, line(3)}, {4, line(4)}, {9, line(9)}};
  for (const CurveKind kind : kAll) {
    const Curve curve = fitCurve(kind, uneven, 3);
    for (const double t : {0.0, 0.4, 2.0, 3.0, 6.7, 9.0}) EXPECT_NEAR(curve(t), line(t), 1e-12) << nameOf(kind);
  }
}

TEST(FitCurve, LagrangeReproducesACubic) {
  const Curve curve = fitCurve(CurveKind::Lagrange, sampled(-2, 7, 10, cubic), 3);
  for (double t = -2; t <= 7; t += 0.13) EXPECT_NEAR(curve(t), cubic(t), 1e-12) << t;
}

TEST(FitCurve, PolynomialReproducesOneOfItsDegreeAndNoHigherOne) {
  const LinePoints points = sampled(-2, 7, 10, cubic);
  const Curve third = fitCurve(CurveKind::Polynomial, points, 3), second = fitCurve(CurveKind::Polynomial, points, 2);
  for (double t = -2; t <= 7; t += 0.13) EXPECT_NEAR(third(t), cubic(t), 1e-12) << t;
  EXPECT_GT(std::abs(second(-2) - cubic(-2)), 0.1);
}

TEST(FitCurve, PolynomialFarFromZeroIsAsExact) {
  const LinePoints points = sampled(1000, 1009, 30, [](double t) { return cubic(t - 1000); });
  const Curve curve = fitCurve(CurveKind::Polynomial, points, 9);
  for (double t = 1000; t <= 1009; t += 0.1) EXPECT_NEAR(curve(t), cubic(t - 1000), 1e-10) << t;
}

TEST(FitCurve, LagrangeAndBSplinePassThroughTheirPoints) {
  const LinePoints points = {{0, 1}, {1, 3}, {2.5, -1}, {3, 0}, {4, 0.5}, {6, 2}};
  for (const CurveKind kind : kThroughPoints) {
    const Curve curve = fitCurve(kind, points, 3);
    for (const auto& p : points) EXPECT_NEAR(curve(p.x()), p.y(), 1e-12) << nameOf(kind) << " at " << p.x();
  }
}

TEST(FitCurve, BSplineOfOnePeakHasItsKnownValue) {
  const LinePoints points = {{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 0}};
  const double side = -3.0 / 7.0, peak = 12.0 / 7.0;  // V[1] = V[3] and V[2]: 4 side + peak = 0, 2 side + 4 peak = 6
  const double half = (0.0 + 23.0 * side + 23.0 * peak + side) / 48.0;  // V[0] = 0
  EXPECT_NEAR(fitCurve(CurveKind::BSpline, points, 3)(1.5), half, 1e-12);
}

TEST(FitCurve, BezierEndsAtItsEndsAndIsHeldByItsPoints) {
  const LinePoints points = {{0, 0}, {1, 0}, {2, 1}, {3, 0}, {4, 0}};
  const Curve curve = fitCurve(CurveKind::Bezier, points, 3);
  EXPECT_NEAR(curve(0), 0.0, 1e-12);
  EXPECT_NEAR(curve(4), 0.0, 1e-12);
  EXPECT_NEAR(curve(2), 6.0 / 16.0, 1e-12);  // Bernstein's B(2,4) at 1/2
  EXPECT_NEAR(curve(1), 54.0 / 256.0, 1e-12);
}

TEST(ChooseCurvePoints, TakesTheEndsAndEvenlyBetween) {
  const CurveStretch stretch = chooseCurvePoints(sampled(0, 360, 361, line), 10);
  ASSERT_EQ(stretch.points.size(), 10u);
  EXPECT_EQ(stretch.checks.size(), 351u);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(stretch.points[static_cast<std::size_t>(i)].x(), 40.0 * i);
}

TEST(ChooseCurvePoints, HasNoneWithoutAPointToSpare) {
  EXPECT_TRUE(chooseCurvePoints({}, 4).points.empty());
  EXPECT_TRUE(chooseCurvePoints(sampled(0, 1, 4, line), 4).points.empty());
  EXPECT_EQ(chooseCurvePoints(sampled(0, 1, 5, line), 4).checks.size(), 1u);
}

TEST(CompareCurves, EveryCurveOfALineIsExact) {
  const auto curves = compareCurves(sampled(0, 9, 50, line), {});
  ASSERT_EQ(curves.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(curves[i].kind, kAll[i]);
    EXPECT_NEAR(curves[i].rms, 0.0, 1e-12);
    EXPECT_NEAR(curves[i].largest, 0.0, 1e-12);
    EXPECT_NEAR(curves[i].overshoot, 0.0, 1e-12);
  }
}

TEST(CompareCurves, FiguresOfOneMisplacedCheckAreItsOwn) {
  LinePoints points = sampled(0, 9, 50, [](double) { return 1.0; });
  points[1].y() = 1.003;
  for (const CurveFigures& c : compareCurves(points, {})) {
    EXPECT_NEAR(c.largest, 0.003, 1e-12) << nameOf(c.kind);
    EXPECT_NEAR(c.rms, 0.003 / std::sqrt(40.0), 1e-12) << nameOf(c.kind);
  }
}

TEST(CompareCurves, RungesFunctionMakesLagrangeOvershootAndNotTheOthers) {
  const LinePoints points = sampled(-1, 1, 201, runge);
  const CurveOptions eleven = withPoints(11);
  EXPECT_NEAR(figuresOf(CurveKind::Lagrange, points, eleven).overshoot, 0.957, 0.005);  // Runge 1901: 1.957 at 0.952
  EXPECT_LT(figuresOf(CurveKind::BSpline, points, eleven).overshoot, 0.01);
  EXPECT_EQ(figuresOf(CurveKind::Bezier, points, eleven).overshoot, 0.0);
}

TEST(CompareCurves, BSplineIsTheBestOfADatumWithADip) {
  const auto datum = [](double t) { return 0.006 * std::cos(2 * t) - 0.012 * std::exp(-50.0 * (t - 3.5) * (t - 3.5)); };
  const auto curves = compareCurves(sampled(0, 6.283, 361, datum), withPoints(20));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(curves[3].rms, curves[i].rms) << nameOf(curves[i].kind);
}

TEST(CompareCurves, MorePointsOrAHigherDegreeChangeTheOutcome) {
  const LinePoints points = sampled(-1, 1, 201, runge);
  EXPECT_LT(figuresOf(CurveKind::BSpline, points, withPoints(20)).rms,
            figuresOf(CurveKind::BSpline, points, withPoints(8)).rms / 4);
  EXPECT_LT(figuresOf(CurveKind::Polynomial, points, withPoints(20, 8)).rms,
            figuresOf(CurveKind::Polynomial, points, withPoints(20, 2)).rms / 2);
}

TEST(CompareCurves, IsEmptyWithoutChecks) {
  EXPECT_TRUE(compareCurves({}, {}).empty());
  EXPECT_TRUE(compareCurves(sampled(0, 1, 10, line), {}).empty());
}

TEST(CompareCurves, FiguresAreUnknownUntilCompared) {
  const CurveFigures figures;
  EXPECT_TRUE(std::isnan(figures.rms) && std::isnan(figures.largest) && std::isnan(figures.overshoot));
}

TEST(CurveOptions, RefuseThemselvesByName) {
  EXPECT_EQ(said(firstError(CurveOptions())), "");
  EXPECT_EQ(said(firstError(withPoints(3))), "points, 3, expected 4 to 50");
  EXPECT_EQ(said(firstError(withPoints(51))), "points, 51, expected 4 to 50");
  EXPECT_EQ(said(firstError(withPoints(10, 0))), "degree, 0, expected 1 to 9, below points");
  EXPECT_EQ(said(firstError(withPoints(10, 10))), "degree, 10, expected 1 to 9, below points");
  try {
    compareCurves(sampled(0, 9, 50, line), withPoints(3));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Option);
    EXPECT_STREQ(error.what(), "options: points, 3, expected 4 to 50");
  }
}

TEST(CompareCurves, OvershootIsLookedForAtTwentiethsOfTheWayBetweenPoints) {
  const auto overshootOf = [](double peak) {
    LinePoints points;
    for (int t = 0; t < 5; ++t) points.emplace_back(t, -(t - peak) * (t - peak));
    return figuresOf(CurveKind::Lagrange, points, withPoints(4)).overshoot;  // the parabola itself
  };
  EXPECT_NEAR(overshootOf(2.55), 0.45 * 0.45, 1e-12);                     // over the point at 3
  EXPECT_NEAR(overshootOf(2.525), 0.475 * 0.475 - 0.025 * 0.025, 1e-12);  // looked for at 2.5 and at 2.55
}

}  // namespace tank_datum::curve_comparison_test
