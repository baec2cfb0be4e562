#include "shell/shell_trace.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace tank_datum {
namespace {

constexpr double kColumn = 0.05;       // of the arc [m]
constexpr std::size_t kFewest = 5;     // points of a column
constexpr double kSharpestTurn = 0.4;  // that a plate turns along its arc [m/m]: at a peaked weld, or in a dent
constexpr double kErrors = 4.0;        // standard errors
constexpr double kScattered = 2.0;     // times the usual spread, and the column's slope: several things at once

/// The shell in a column; not seen where its points are few, or scattered.
ShellCell cellOf(std::vector<double>& radii, double most_scatter) {
  if (radii.size() < kFewest) return {};
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

}  // namespace

std::optional<std::vector<ShellCell>> traceShell(const PolarRing& ring, const ShellArc& arc) {
  const double span = arc.to - arc.from;
  const auto each =
      static_cast<std::size_t>(std::max(1.0, span * arc.radius / kColumn / static_cast<double>(arc.steps)));
  const std::size_t last = each * arc.steps;  // column, of those about the stations and between them
  const double width = span / static_cast<double>(last), turned = kSharpestTurn * width * arc.radius;
  if (kScattered * arc.noise > turned) return std::nullopt;  // which hides jumps
  std::vector<std::vector<double>> radii(last + 1);
  ring.around(0.5 * (arc.from + arc.to), 0.5 * (span + width), [&](const PolarPoint& p, double turn) {
    const double share = turn / span + 0.5;
    if (std::abs(p.z - arc.z_from - share * (arc.z_to - arc.z_from)) > arc.half_band) return;
    const double column = std::round(share * static_cast<double>(last));
    radii[static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(last)))].push_back(p.radius);
  });
  std::vector<ShellCell> columns;
  for (std::vector<double>& column : radii) columns.push_back(cellOf(column, kScattered * arc.noise + turned));
  for (std::size_t i = 1; i < last; ++i) {
    if (!columns[i].seen()) columns[i] = between(columns[i - 1], columns[i + 1]);
  }
  const auto jumps = [&](const ShellCell& a, const ShellCell& b) {
    if (!a.seen() || !b.seen()) return true;
    const double error = kMedianOverMean * arc.noise *
                         std::sqrt(1.0 / static_cast<double>(a.points) + 1.0 / static_cast<double>(b.points));
    return std::abs(a.radius - b.radius) > turned + kErrors * error;
  };
  if (jumps(arc.first, columns.front()) || jumps(columns.back(), arc.last)) return std::nullopt;
  for (std::size_t i = 1; i <= last; ++i) {
    if (jumps(columns[i - 1], columns[i])) return std::nullopt;
  }
  std::vector<ShellCell> stations;
  for (std::size_t i = each; i < last; i += each) stations.push_back(columns[i]);
  return stations;
}

}  // namespace tank_datum
