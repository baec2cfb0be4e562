#include "fit/spline.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestPoints = 12;

/// Where an azimuth falls: the first of its four control points, and the basis there.
struct Span {
  Eigen::Index first;
  Eigen::Vector4d basis;
};

Span spanAt(double azimuth, Eigen::Index controls) {
  const double turn = azimuth / kTwoPi;
  const double position = (turn - std::floor(turn)) * static_cast<double>(controls);
  const double whole = std::min(std::floor(position), static_cast<double>(controls - 1));
  return {static_cast<Eigen::Index>(whole), cubicBasis(position - whole)};
}

struct Fit {
  Eigen::MatrixX3d controls;
  double squares = 0;  ///< sum of squared residuals
};

/// Normal equations of the fit with `controls` control points: one pass over the points, four unknowns each.
Fit fitControls(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& azimuths,
                Eigen::Index controls) {
  constexpr double kBridge = 1e-9;  // of the data's weight: nothing where points are, everything where there are none
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(controls, controls);
  Eigen::MatrixX3d rhs = Eigen::MatrixX3d::Zero(controls, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Span span = spanAt(azimuths[i], controls);
    for (int a = 0; a < 4; ++a) {
      const Eigen::Index row = (span.first + a) % controls;
      rhs.row(row) += span.basis[a] * points[i].transpose();
      for (int b = 0; b < 4; ++b) normal(row, (span.first + b) % controls) += span.basis[a] * span.basis[b];
    }
  }
  const double bridge = kBridge * static_cast<double>(points.size()) / static_cast<double>(controls);
  const Eigen::Vector3d difference(1.0, -2.0, 1.0);
  for (Eigen::Index row = 0; row < controls; ++row) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        normal((row + a) % controls, (row + b) % controls) += bridge * difference[a] * difference[b];
      }
    }
  }
  Fit fit;
  fit.controls = normal.ldlt().solve(rhs);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Span span = spanAt(azimuths[i], controls);
    Eigen::Vector3d residual = points[i];
    for (int a = 0; a < 4; ++a) residual -= span.basis[a] * fit.controls.row((span.first + a) % controls).transpose();
    fit.squares += residual.squaredNorm();
  }
  return fit;
}

/// Schwarz's criterion over a ladder of control-point counts.
Fit chooseFit(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& azimuths) {
  const double n = 3.0 * static_cast<double>(points.size());
  Fit best;
  double best_score = std::numeric_limits<double>::infinity();
  for (const Eigen::Index controls : {4, 6, 8, 12, 16, 24, 36, 48, 72, 90, 120, 180}) {
    if (static_cast<std::size_t>(2 * controls) > points.size() && controls > 4) break;
    Fit fit = fitControls(points, azimuths, controls);
    const double score =
        n * portable::log(fit.squares / n + 1e-18) + 3.0 * static_cast<double>(controls) * portable::log(n);
    if (score < best_score) {
      best_score = score;
      best = std::move(fit);
    }
  }
  return best;
}

}  // namespace

Eigen::Vector4d cubicBasis(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return Eigen::Vector4d(1 - 3 * t + 3 * t2 - t3, 4 - 6 * t2 + 3 * t3, 1 + 3 * t + 3 * t2 - 3 * t3, t3) / 6.0;
}

Eigen::Vector3d ClosedSpline::at(double azimuth) const {
  const Span span = spanAt(azimuth, control_points.rows());
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (int a = 0; a < 4; ++a) {
    point += span.basis[a] * control_points.row((span.first + a) % control_points.rows()).transpose();
  }
  return point;
}

double ClosedSpline::distance(const Eigen::Vector3d& point, double azimuth) const {
  // golden-section search within one span on either side; the curve is smooth and almost straight there
  constexpr double kGolden = 0.6180339887498949;
  const double reach = kTwoPi / static_cast<double>(control_points.rows());
  double low = azimuth - reach, high = azimuth + reach;
  const auto squared = [&](double a) { return (at(a) - point).squaredNorm(); };
  for (int step = 0; step < 40; ++step) {
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    (squared(left) < squared(right) ? high : low) = squared(left) < squared(right) ? right : left;
  }
  return std::sqrt(squared(0.5 * (low + high)));
}

ClosedSpline fitClosedSpline(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& azimuths,
                             const SplineOptions& options) {
  ClosedSpline spline;
  if (points.size() < kFewestPoints) return spline;
  std::vector<Eigen::Vector3d> used;
  std::vector<double> used_azimuths;
  std::vector<std::size_t> checks;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % static_cast<std::size_t>(options.check_every) == 0) {
      checks.push_back(i);
    } else {
      used.push_back(points[i]);
      used_azimuths.push_back(azimuths[i]);
    }
  }
  const auto controls = static_cast<Eigen::Index>(options.control_points);
  spline.control_points =
      (controls > 0 ? fitControls(used, used_azimuths, controls) : chooseFit(used, used_azimuths)).controls;
  double squares = 0;
  spline.max_residual = 0;
  for (const std::size_t i : checks) {
    const double distance = spline.distance(points[i], azimuths[i]);
    squares += distance * distance;
    spline.max_residual = std::max(spline.max_residual, distance);
  }
  spline.check_points = checks.size();
  spline.rms = std::sqrt(squares / static_cast<double>(checks.size()));
  return spline;
}

}  // namespace tank_datum
