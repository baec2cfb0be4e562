#include "foot/shell_line.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/fast_floor.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "fit/surface_rows.h"
#include "foot/shell_objects.h"
#include "locate/ring_shape.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {
namespace {

constexpr std::size_t kDense = 500;         // points of a window that columns on both sides hold
constexpr std::size_t kPointsPerCell = 40;  // enough for a mode, few enough for cells finer than the lobes of a shell

/// Replaces cells that stand apart from the running median of their neighbours by NaN: pipes, outliers.
void dropStrays(ShellCells& cells) {
  constexpr std::ptrdiff_t kReach = 4;
  const auto count = static_cast<std::ptrdiff_t>(cells.radius.size());
  const std::vector<double> given = cells.radius;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    std::vector<double> around;
    for (std::ptrdiff_t j = i - kReach; j <= i + kReach; ++j) {
      const double r = given[static_cast<std::size_t>((j + count) % count)];
      if (std::isfinite(r)) around.push_back(r);
    }
    double& cell = cells.radius[static_cast<std::size_t>(i)];
    if (std::abs(cell - median(around)) > mostTurn(cells, kReach * cells.arc)) cell = kUnknown;
  }
}

/// What the shell's points scatter by in a usual cell; where soil lies against most of it, in one of those without.
double noiseOf(const std::vector<double>& spreads) {
  constexpr double kBare = 0.25;  // of the cells
  constexpr double kSoil = 4.0;   // times as much as those scatter
  const double bare = quantile(spreads, kBare), usual = median(spreads);
  return usual > kSoil * bare ? bare : usual;
}

/// A point of the shell: arc from the window's middle, as it is and of its column, height above the foot, radius [m].
struct ShellRow {
  double at, t, h, radius;
};

/// Puts the points of each column of a scan at its middle: where rays graze the shell, range noise moves points along
/// it by much and across it by little, which would pass for a turn of the shell. Columns closer than noise are left,
/// and so are few points together, which chance brings about.
/// @param rows   in order of `at`
/// @param width  of the window [m]
void uprightColumns(std::vector<ShellRow>& rows, double width, double noise) {
  constexpr double kApart = 3.0, kWide = 12.0;  // times the noise: columns, and one of them at most
  constexpr double kResolves = 24.0;            // times the noise: a window that columns can be told apart in
  constexpr std::size_t kColumn = 5;            // points
  if (width < kResolves * noise) return;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    double sum = 0.0;
    for (end = begin; end < rows.size() && (end == begin || rows[end].at - rows[end - 1].at < kApart * noise); ++end)
      sum += rows[end].at;
    if (end - begin < kColumn || rows[end - 1].at - rows[begin].at > kWide * noise) continue;
    for (std::size_t i = begin; i < end; ++i) rows[i].t = sum / static_cast<double>(end - begin);
  }
}

template <typename Keep>
ShellOutline outline(const PolarRing& ring, double tank_radius, const Keep& keep) {
  const PolarPoints& points = ring.points();
  std::vector<char> kept(points.size());
  forEachRun(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) kept[i] = keep(points[i]);
  });
  const auto count = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 1));
  const std::size_t cells = std::clamp<std::size_t>(count / kPointsPerCell, 36, 1440);
  ShellOutline result;
  result.radius.resize(cells);
  std::vector<double> spreads(cells);
  forEachIndex(cells, 0, [&](std::size_t cell) {
    const auto [begin, end] = ring.inCell(cell, cells);
    std::vector<double> radii;
    for (std::size_t i = begin; i < end; ++i) {
      if (kept[i]) radii.push_back(points[i].radius);
    }
    result.radius[cell] = densestOfCell(radii);
    spreads[cell] = std::isfinite(result.radius[cell]) ? robustSigma(radii, result.radius[cell]) : kUnknown;
  });
  spreads.erase(std::remove_if(spreads.begin(), spreads.end(), [](double s) { return std::isnan(s); }), spreads.end());
  result.noise = std::max(noiseOf(spreads), 1e-6);  // points without noise are a shell too
  ShellCells shell{std::move(result.radius), result.noise, kTwoPi * tank_radius / static_cast<double>(cells)};
  dropStrays(shell);
  result.radius = std::move(shell.radius);
  return result;
}

}  // namespace

bool ShellLine::isSupportedWithin(double step) const {
  constexpr double kCoarse = 1.25;  // between columns, in steps
  return before <= 0.5 * step || after <= 0.5 * step || before + after <= kCoarse * step;
}

double ShellOutline::at(double azimuth) const { return betweenCells(radius, azimuth); }

ShellOutline outlineShell(const PolarRing& ring, const Tank& tank, double reach) {
  ShellOutline shell = outline(ring, tank.circle.radius,
                               [&](const PolarPoint& p) { return p.z > tank.foot(p.azimuth) + kAboveFoot * reach; });
  const double arc = kTwoPi * tank.circle.radius / static_cast<double>(shell.radius.size());
  shell.radius = withoutObjects({std::move(shell.radius), shell.noise, arc});
  return shell;
}

ShellOutline outlineBand(const PolarRing& ring, double radius) {
  return outline(ring, radius, [](const PolarPoint&) { return true; });
}

ShellLine fitShellLine(const PolarRing& ring, const ShellOutline& outline, const ShellWindow& window) {
  constexpr std::size_t kUnknowns = 4;
  constexpr double kTurn = 0.05;  // what lobes turn a shell by against its circle (standard deviation)
  constexpr double kBend = 4.0;   // and bend it by, times as much as the circle bends
  ShellLine line;
  const double start = outline.at(window.azimuth);
  if (!std::isfinite(start)) return line;
  std::vector<ShellRow> seen;
  ring.around(window.azimuth, window.half_width, [&](const PolarPoint& p, double turn) {
    const double h = p.z - window.foot;
    if (turn < -window.back || turn > window.on) return;
    if (h >= window.heights.from && h <= window.heights.to &&
        std::abs(p.radius - outline.at(p.azimuth)) < kOnShell * outline.noise) {
      seen.push_back({turn * start, turn * start, h, p.radius});
    }
  });
  if (seen.size() < 3 * kUnknowns) return line;
  if (seen.size() < kDense) uprightColumns(seen, 2.0 * window.half_width * start, outline.noise);
  SurfaceRows rows;
  rows.reserve(seen.size());
  for (const ShellRow& row : seen) rows.add(row.h, row.t, row.radius);
  rows.close();
  SurfacePrior prior;
  if (outline.isResolved(window.heights.to)) {
    prior = {{0.0, 0.0, 1.0 / square(kTurn), square(start / kBend)}, outline.noise};
  }
  const std::optional<SurfaceFit> fit = fitRobustly(rows, prior);
  if (!fit) return line;
  line.noise = fit->noise;
  line.radius = fit->solution[0];
  line.lean = fit->solution[1];
  line.turn_slope = fit->solution[2];
  line.bend = fit->solution[3];
  const Eigen::Matrix2d upright = fit->normal.topLeftCorner<2, 2>();  // of radius and lean alone
  const double variance = fit->inverse(0, 0);
  line.sigma_radius = line.noise * std::sqrt(variance);
  line.sigma_along = line.noise * std::sqrt(std::max(0.0, variance - upright.inverse()(0, 0)));
  line.straight_to = window.heights.to;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows.weights()[i] <= 0.0) continue;
    ++line.points;
    double& nearest = seen[i].at < 0 ? line.before : line.after;
    if (!(nearest <= std::abs(seen[i].at))) nearest = std::abs(seen[i].at);
  }
  return line;
}

ShellModel::ShellModel(std::vector<ShellLine> lines, double first) : lines_(std::move(lines)), first_(first) {}

double ShellModel::at(double azimuth) const {
  const double turn = (azimuth - first_) / kTwoPi, step = kTwoPi / static_cast<double>(lines_.size());
  const double position = (turn - fastFloor(turn)) * static_cast<double>(lines_.size());
  const auto left = static_cast<std::size_t>(position) % lines_.size();
  const double share = position - fastFloor(position);
  const ShellLine& a = lines_[left];
  const ShellLine& b = lines_[(left + 1) % lines_.size()];
  const auto radius = [&](const ShellLine& line, double angle) { return line.at(angle * line.radius, 0.0); };
  if (!a.seen()) return radius(b, (share - 1.0) * step);
  if (!b.seen()) return radius(a, share * step);
  return (1.0 - share) * radius(a, share * step) + share * radius(b, (share - 1.0) * step);
}

}  // namespace tank_datum
