#include "fit/curve_comparison.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/refusal.h"
#include "fit/spline.h"

namespace tank_datum {
namespace {

constexpr CurveKind kKinds[] = {CurveKind::Lagrange, CurveKind::Bezier, CurveKind::Polynomial, CurveKind::BSpline};

double mapped(double t, const LinePoints& points, double low, double high) {
  return low + (high - low) * (t - points.front().x()) / (points.back().x() - points.front().x());
}

/// Which stretch between two points t lies in.
std::size_t spanOf(double t, const LinePoints& points) {
  const auto next =
      std::upper_bound(points.begin() + 1, points.end() - 1, t, [](double v, const auto& p) { return v < p.x(); });
  return static_cast<std::size_t>(next - points.begin()) - 1;
}

/// z of a curve (t, z) of a parameter where it reaches t, by bisection.
template <typename Parametric>
double elevationAt(double t, double low, double high, const Parametric& curve) {
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (curve(middle).x() < t ? low : high) = middle;
  }
  return curve(0.5 * (low + high)).y();
}

Curve lagrange(const LinePoints& points) {
  // over an interval of length 4 the weights neither grow nor vanish with the number of points
  std::vector<double> places, weights;
  for (const auto& p : points) places.push_back(mapped(p.x(), points, -2.0, 2.0));
  for (const double place : places) {
    double product = 1.0;
    for (const double other : places) product *= other == place ? 1.0 : place - other;
    weights.push_back(1.0 / product);
  }
  return [points, places, weights](double t) {
    const double at = mapped(t, points, -2.0, 2.0);
    double above = 0.0, below = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (at == places[i]) return points[i].y();
      const double share = weights[i] / (at - places[i]);
      above += share * points[i].y();
      below += share;
    }
    return above / below;
  };
}

Curve bezier(const LinePoints& points) {
  const auto deCasteljau = [points](double u) {
    LinePoints level = points;
    for (std::size_t left = level.size() - 1; left > 0; --left) {
      for (std::size_t i = 0; i < left; ++i) level[i] = (1.0 - u) * level[i] + u * level[i + 1];
    }
    return level.front();
  };
  return [deCasteljau](double t) { return elevationAt(t, 0.0, 1.0, deCasteljau); };
}

/// Chebyshev's polynomials T0 .. Tdegree at x in [-1, 1].
Eigen::RowVectorXd chebyshevRow(double x, int degree) {
  Eigen::RowVectorXd row(degree + 1);
  row[0] = 1.0;
  if (degree > 0) row[1] = x;
  for (int n = 2; n <= degree; ++n) row[n] = 2.0 * x * row[n - 1] - row[n - 2];
  return row;
}

Curve polynomial(const LinePoints& points, int degree) {
  Eigen::MatrixXd design(points.size(), degree + 1);
  Eigen::VectorXd z(points.size());
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    design.row(i) = chebyshevRow(mapped(p.x(), points, -1.0, 1.0), degree);
    z[i] = p.y();
  }
  const Eigen::VectorXd coefficients = design.colPivHouseholderQr().solve(z);
  return [points, coefficients, degree](double t) -> double {
    return chebyshevRow(mapped(t, points, -1.0, 1.0), degree) * coefficients;
  };
}

/// Control points -1 .. n of the uniform cubic B-spline through points 0 .. n - 1: (V[i-1] + 4 V[i] + V[i+1]) / 6 =
/// Q[i] (the paper's basis at t = 0), a tridiagonal system closed by V[-1] - 2 V[0] + V[1] = 0 and likewise at the
/// other end, which make V[0] = Q[0] and V[n-1] = Q[n-1].
LinePoints controlPointsThrough(const LinePoints& points) {
  const std::size_t last = points.size() - 1;
  LinePoints v = points;
  std::vector<double> upper(points.size(), 0.0);
  for (std::size_t i = 1; i < last; ++i) {  // Thomas's elimination
    const double pivot = 4.0 - upper[i - 1];
    upper[i] = 1.0 / pivot;
    v[i] = (6.0 * points[i] - v[i - 1]) / pivot;
  }
  for (std::size_t i = last - 1; i > 0; --i) v[i] -= upper[i] * v[i + 1];
  v.insert(v.begin(), 2.0 * v[0] - v[1]);
  v.push_back(2.0 * v[last + 1] - v[last]);
  return v;
}

Curve cubicBSpline(const LinePoints& points) {
  return [points, controls = controlPointsThrough(points)](double t) {
    const std::size_t span = spanOf(t, points);
    const auto piece = [&controls, span](double u) -> Eigen::Vector2d {
      const Eigen::Vector4d basis = cubicBasis(u);
      return basis[0] * controls[span] + basis[1] * controls[span + 1] + basis[2] * controls[span + 2] +
             basis[3] * controls[span + 3];
    };
    return elevationAt(t, 0.0, 1.0, piece);
  };
}

double overshootOf(const Curve& curve, const LinePoints& line) {
  constexpr int kLooks = 20;  // between two neighbouring points of the line
  const auto byElevation = [](const auto& a, const auto& b) { return a.y() < b.y(); };
  const auto [lowest, highest] = std::minmax_element(line.begin(), line.end(), byElevation);
  double overshoot = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (int look = 0; look < kLooks; ++look) {
      const double z = curve(line[i].x() + (line[i + 1].x() - line[i].x()) * look / kLooks);
      overshoot = std::max({overshoot, z - highest->y(), lowest->y() - z});
    }
  }
  return overshoot;
}

}  // namespace

const char* nameOf(CurveKind kind) {
  switch (kind) {
    case CurveKind::Lagrange:
      return "Lagrange";
    case CurveKind::Bezier:
      return "Bezier";
    case CurveKind::Polynomial:
      return "polynomial";
    case CurveKind::BSpline:
      return "B-spline";
  }
  return "";
}

std::optional<Refusal> firstError(const CurveOptions& o) {
  if (o.points < 4 || o.points > 50) return Refusal{"points", std::to_string(o.points), "4 to 50"};
  if (o.degree >= 1 && o.degree < o.points) return std::nullopt;
  return Refusal{"degree", std::to_string(o.degree), "1 to " + std::to_string(o.points - 1) + ", below points"};
}

CurveStretch chooseCurvePoints(const LinePoints& line, int points) {
  CurveStretch stretch;
  const auto count = static_cast<std::size_t>(points);
  if (line.size() <= count) return stretch;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t next = stretch.points.size();
    const std::size_t wanted = (2 * next * (line.size() - 1) + count - 1) / (2 * (count - 1));  // rounded
    (i == wanted ? stretch.points : stretch.checks).push_back(line[i]);
  }
  return stretch;
}

Curve fitCurve(CurveKind kind, const LinePoints& points, int degree) {
  switch (kind) {
    case CurveKind::Lagrange:
      return lagrange(points);
    case CurveKind::Bezier:
      return bezier(points);
    case CurveKind::Polynomial:
      return polynomial(points, degree);
    case CurveKind::BSpline:
      return cubicBSpline(points);
  }
  return {};
}

std::vector<CurveFigures> compareCurves(const LinePoints& line, const CurveOptions& options) {
  refuseFirst(firstError(options));
  const CurveStretch stretch = chooseCurvePoints(line, options.points);
  std::vector<CurveFigures> all;
  if (stretch.checks.empty()) return all;
  for (const CurveKind kind : kKinds) {
    const Curve curve = fitCurve(kind, stretch.points, options.degree);
    CurveFigures figures{kind, 0.0, 0.0, overshootOf(curve, line)};
    for (const auto& check : stretch.checks) {
      const double deviation = check.y() - curve(check.x());
      figures.rms += deviation * deviation / static_cast<double>(stretch.checks.size());
      figures.largest = std::max(figures.largest, std::abs(deviation));
    }
    figures.rms = std::sqrt(figures.rms);
    all.push_back(figures);
  }
  return all;
}

}  // namespace tank_datum
