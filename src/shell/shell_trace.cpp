#include "shell/shell_trace.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/shell_line.h"

namespace tank_datum {
namespace {

constexpr double kColumn = 0.05;       // of the arc [m]
constexpr std::size_t kFewest = 5;     // points of a column
constexpr double kSharpestTurn = 0.4;  // that a plate turns along its arc [m/m]: at a peaked weld, or in a dent
constexpr double kErrors = 4.0;        // standard errors
constexpr double kScattered = 2.0;     // times the usual spread, and the column's slope: several things at once

/// A point of the band: arc from the middle of what is traced, and radius [m].
struct BandPoint {
  double t, radius;
};
using Column = std::vector<BandPoint>;  // in order of t

/// The shell in a column; not seen where its points are few, or scattered.
ShellCell cellOf(const Column& column, double most_scatter) {
  if (column.size() < kFewest) return {};
  std::vector<double> radii;
  for (const BandPoint& p : column) radii.push_back(p.radius);
  const double radius = median(radii), spread = robustSigma(radii, radius);
  if (spread > most_scatter) return {};
  const auto points = static_cast<double>(radii.size());
  return {radius, kMedianOverMean * std::max(spread, 1e-6) / std::sqrt(points), 1.0, radii.size()};
}

/// Of a column that is not seen, between two that are.
ShellCell between(const ShellCell& a, const ShellCell& b) {
  if (!a.seen() || !b.seen()) return {};
  return {0.5 * (a.radius + b.radius), 0.5 * std::hypot(a.sigma, b.sigma), 1.0, a.points + b.points};
}

/// What the points are off a parabola, in all [m].
double offParabola(const Column& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto rowOf = [&](const BandPoint& p) {
    const double t = (p.t - points.front().t) / kColumn;
    return Eigen::Vector3d(1.0, t, t * t);
  };
  for (const BandPoint& p : points) {
    normal += rowOf(p) * rowOf(p).transpose();
    right += (p.radius - points.front().radius) * rowOf(p);
  }
  const Eigen::Vector3d solution = normal.ldlt().solve(right);
  double off = 0.0;
  for (const BandPoint& p : points) off += std::abs(p.radius - points.front().radius - rowOf(p).dot(solution));
  return off;
}

/// What they are off two levels, one before the place that parts them best and one beyond it [m].
double offStep(const Column& points) {
  const auto count = static_cast<double>(points.size());
  double sum = 0.0, below = 0.0, explained = 0.0, before = 0.0, beyond = 0.0;
  std::size_t place = 0;
  for (const BandPoint& p : points) sum += p.radius - points.front().radius;
  for (std::size_t k = 1; k < points.size(); ++k) {
    below += points[k - 1].radius - points.front().radius;
    const auto n = static_cast<double>(k);
    const double squares = square(below) / n + square(sum - below) / (count - n);
    if (squares <= explained) continue;
    explained = squares, place = k;
    before = points.front().radius + below / n, beyond = points.front().radius + (sum - below) / (count - n);
  }
  double off = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) off += std::abs(points[k].radius - (k < place ? before : beyond));
  return off;
}

/// Whether the radius steps between two levels [m] rather than turns: what is put upon the shell has an edge, a dent or
/// a peaked weld has none. Judged by what points are off, not by squares: some may be of the edge itself.
bool isStep(const std::vector<Column>& columns, std::size_t from, std::size_t to, double inner, double outer) {
  Column points;
  for (std::size_t i = from; i <= to; ++i) {
    for (const BandPoint& p : columns[i]) {
      if (p.radius >= inner && p.radius <= outer) points.push_back(p);
    }
  }
  return points.size() > 3 && offStep(points) < offParabola(points);
}

/// The points of an arc in its columns: the first and the last are about its ends.
std::vector<Column> columnsOf(const PolarRing& ring, const ShellArc& arc, std::size_t last) {
  const double span = arc.to - arc.from, width = span / static_cast<double>(last);
  std::vector<Column> columns(last + 1);
  ring.around(0.5 * (arc.from + arc.to), 0.5 * (span + width), [&](const PolarPoint& p, double turn) {
    const double share = turn / span + 0.5;
    if (std::abs(p.z - arc.z_from - share * (arc.z_to - arc.z_from)) > arc.half_band) return;
    const double column = std::clamp(std::round(share * static_cast<double>(last)), 0.0, static_cast<double>(last));
    columns[static_cast<std::size_t>(column)].push_back({turn * arc.radius, p.radius});
  });
  return columns;
}

}  // namespace

ShellTrace traceShell(const PolarRing& ring, const ShellArc& arc) {
  const double length = arc.radius * (arc.to - arc.from);
  const auto each = static_cast<std::size_t>(std::max(1.0, length / kColumn / static_cast<double>(arc.steps)));
  const std::size_t last = each * arc.steps;  // column, of those about the stations and between them
  const double width = length / static_cast<double>(last), turned = kSharpestTurn * width;
  const double most_scatter = kScattered * arc.noise + turned;
  ShellTrace trace;
  if (kScattered * arc.noise > turned) return trace;  // which hides jumps
  const std::vector<Column> seen = columnsOf(ring, arc, last);
  std::vector<ShellCell> columns;
  for (const Column& column : seen) columns.push_back(cellOf(column, most_scatter));
  for (std::size_t i = 1; i < last; ++i) {
    if (!columns[i].seen()) columns[i] = between(columns[i - 1], columns[i + 1]);
  }
  const auto jumps = [&](const ShellCell& a, const ShellCell& b) {
    const double error = kMedianOverMean * arc.noise *
                         std::sqrt(1.0 / static_cast<double>(a.points) + 1.0 / static_cast<double>(b.points));
    return std::abs(a.radius - b.radius) > turned + kErrors * error;
  };
  const auto steps = [&](std::size_t from, std::size_t to) {
    const auto [inner, outer] = std::minmax(columns[from].radius, columns[to].radius);
    return outer - inner > bendAlong(static_cast<double>(to - from) * width) &&
           isStep(seen, from, to, inner - most_scatter, outer + most_scatter);
  };
  const auto runsOn = [&](const ShellCell& a, const ShellCell& b) { return a.seen() && b.seen() && !jumps(a, b); };
  trace.runs_on = runsOn(arc.first, columns.front()) && runsOn(columns.back(), arc.last);
  for (std::size_t i = 0, on = 0; i < last; i = on) {
    on = i + 1;
    if (!columns[i].seen() || !columns[on].seen()) {
      trace.runs_on = false;
      continue;
    }
    bool edge = jumps(columns[i], columns[on]);
    const std::size_t beyond = std::min(i + 2, last);
    if (!edge && columns[beyond].seen() && steps(i, beyond)) edge = true, on = beyond;
    if (!edge) continue;
    trace.runs_on = false;
    trace.stepped += columns[on].radius - columns[i].radius;
  }
  for (std::size_t i = each; trace.runs_on && i < last; i += each) trace.stations.push_back(columns[i]);
  return trace;
}

}  // namespace tank_datum
