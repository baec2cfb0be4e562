#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// The four curves that the paper lays through ten points of a datum (its Fig. 3).
enum class CurveKind {
  Lagrange,    ///< the polynomial through all points, barycentric form (Berrut and Trefethen 2004)
  Bezier,      ///< with the points as its control points
  Polynomial,  ///< least squares, in Chebyshev's basis
  BSpline,     ///< uniform, cubic, through all points, without bend at its ends
};

/// The name used in tables: "Lagrange", "Bezier", "polynomial", "B-spline".
const char* nameOf(CurveKind kind);

struct CurveOptions {
  int points = 10;  ///< of the line that the curves are laid through, evenly chosen; at least 4, at most 50
  int degree = 3;   ///< of the least-squares polynomial, at least 1, below the number of points
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const CurveOptions& options);

/// Places on a line: t along it, in any unit, and the elevation z [m].
using LinePoints = std::vector<Eigen::Vector2d>;

/// A line taken apart: its two ends and points evenly between them, and all others.
struct CurveStretch {
  LinePoints points, checks;
};

/// Both empty when the line has no point to spare for a check.
CurveStretch chooseCurvePoints(const LinePoints& line, int points);

/// z against t, between the first and the last point.
using Curve = std::function<double(double t)>;

/// @param points  at least 4, t ascending
Curve fitCurve(CurveKind kind, const LinePoints& points, int degree);

/// How well a curve does; NaN until compared.
struct CurveFigures {
  CurveKind kind = CurveKind::Lagrange;
  double rms = std::numeric_limits<double>::quiet_NaN();      ///< of the check points' elevations above it [m]
  double largest = std::numeric_limits<double>::quiet_NaN();  ///< of them [m]
  /// Beyond the range of all elevations given, looked for at twentieths of the way between neighbours [m].
  double overshoot = std::numeric_limits<double>::quiet_NaN();
};

/// The four curves in the order of CurveKind; empty without check points.
/// @param line  t ascending
/// @throws Error (Option)
std::vector<CurveFigures> compareCurves(const LinePoints& line, const CurveOptions& options);

}  // namespace tank_datum
