#include "shell/shell_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "shell/shell_trace.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {
namespace {

constexpr std::size_t kPlenty = 40;           // points for four unknowns
constexpr double kWantedSigma = 0.00025;      // a cell borrows points from its neighbours until it is this good [m]
constexpr double kGood = 2.0 * kWantedSigma;  // good enough, whatever the others are [m]
constexpr double kWidestArc = 0.4;  // but no further: a wave of 3 m is a parabola over twice that to 0.2 % [m]
constexpr double kSteepest = 0.2;   // of a shell; a roof is flatter [m/m]

/// The standard error of a line's radius with its noise drawn towards that of a wider window: few points that happen
/// to agree are not as good as they look, and a window must not stop growing on their word.
double sigmaOf(const ShellLine& line, double usual_noise) {
  constexpr double kWorth = 80.0;  // points that the wider window's noise counts for
  const auto points = static_cast<double>(line.points);
  const double ratio = usual_noise / line.noise;
  return line.sigma_radius * std::sqrt((points + kWorth * ratio * ratio) / (points + kWorth));
}

/// Where a cell of the shell is looked for.
struct CellPlace {
  double direction;  ///< [rad]
  double z;          ///< [m]
  double radius;     ///< of the shell, roughly [m]
};

/// Coarse stations look at a degree of the shell as fine ones do.
/// @param step  between stations [rad]
ShellCell fitCell(const PolarRing& ring, const ShellOutline& outline, const CellPlace& at, double step,
                  double half_band) {
  const double own = std::min(step, kTwoPi / 360.0), widest = std::max(own, kWidestArc / at.radius);
  const ShellHeights band{-half_band, half_band};
  const ShellLine wide = fitShellLine(ring, outline, {at.direction, widest, at.z, band});
  ShellCell cell;
  if (wide.points < kPlenty) return cell;
  for (double half = 0.5 * own;; half *= 1.5) {
    const ShellLine line = fitShellLine(ring, outline, {at.direction, half, at.z, band});
    const bool stands = line.isSupportedWithin(own * at.radius) && std::abs(line.lean) < kSteepest;
    if (line.points >= kPlenty && stands) {
      cell = {line.radius, sigmaOf(line, wide.noise), std::max(1.0, 2.0 * half / step), line.points};
    }
    if (cell.sigma < kWantedSigma || 1.5 * half > widest) return cell;
  }
}

/// The median standard error of a row's cells [m]; NaN where none is seen.
double usualSigma(const std::vector<ShellCell>& row) {
  std::vector<double> sigmas;
  for (const ShellCell& cell : row) {
    if (cell.seen()) sigmas.push_back(cell.sigma);
  }
  return median(std::move(sigmas));
}

/// Takes out the cells whose points do not agree on a surface as the others' do: seen past the edge of something.
void dropPoor(std::vector<ShellCell>& row) {
  constexpr double kPoor = 4.0;  // times the usual standard error
  const double worst = std::max(kGood, kPoor * usualSigma(row));
  for (ShellCell& cell : row) {
    if (cell.sigma > worst) cell = {};
  }
}

/// Drops rows that are usually known far worse than the others: through the underside of a wind girder, which is level,
/// any radius fits.
void dropPoorRows(std::vector<std::vector<ShellCell>>& rows) {
  constexpr double kFar = 20.0;  // times the usual standard error
  std::vector<double> sigmas;
  for (const auto& row : rows) {
    const double usual = usualSigma(row);
    if (std::isfinite(usual)) sigmas.push_back(usual);
  }
  const double worst = std::max(kGood, kFar * median(std::move(sigmas)));
  for (auto& row : rows) {
    if (usualSigma(row) > worst) row.assign(row.size(), {});
  }
}

/// Whether two places may be one shell, which bends by so much between them [m].
bool mayBeOne(const ShellCell& a, const ShellCell& b, double bend) {
  return std::abs(a.radius - b.radius) <= bend + 4.0 * std::hypot(a.sigma, b.sigma);
}

/// The next station after this one that is seen, from there on round the ring; row.size() further where none other is.
std::size_t nextSeen(const std::vector<ShellCell>& row, std::size_t i) {
  std::size_t next = i + 1;
  while (next < i + row.size() && !row[next % row.size()].seen()) ++next;
  return next;
}

/// With height: plates are bent by some centimetres within a course.
double bendUp(double rise) { return 0.02 + 0.02 * std::min(rise, 2.0); }

/// Sets of cells that are joined (union-find).
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(b)] = of(a); }

 private:
  std::vector<std::size_t> parent_;
};

/// Whether two stations of a row, so many steps apart, may be one shell by their radii.
bool isNear(const ShellCell& a, const ShellCell& b, double arc) { return mayBeOne(a, b, bendAlong(arc)); }

void joinAlong(const ShellGrid& grid, std::size_t k, Parts& parts) {
  const std::vector<ShellCell>& row = grid.cells[k];
  const std::size_t count = row.size(), first = k * count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = nextSeen(row, i);
    if (!row[i].seen() || next == i + count) continue;
    const double arc = static_cast<double>(next - i) * grid.step;
    if (row[i].runs_on || isNear(row[i], row[next % count], arc)) parts.join(first + i, first + next % count);
  }
}

void joinUp(const ShellGrid& grid, std::size_t station, Parts& parts) {
  const std::size_t count = grid.cells.front().size();
  std::size_t below = grid.heights.size();  // none yet
  for (std::size_t k = 0; k < grid.heights.size(); ++k) {
    const ShellCell& cell = grid.cells[k][station];
    if (!cell.seen()) continue;
    if (below < k) {
      const double bend = bendUp(grid.heights[k] - grid.heights[below]);
      if (mayBeOne(cell, grid.cells[below][station], bend)) parts.join(below * count + station, k * count + station);
    }
    below = k;
  }
}

/// Traces the shell from station to station where lines cannot be fitted to it, or lie apart: over a dent or a peaked
/// weld narrower than they are.
/// @param z  of the row at every station [m]
void traceRow(const PolarRing& ring, const std::vector<double>& z, const ShellArc& usual, std::vector<ShellCell>& row) {
  const std::size_t count = row.size();
  const double step = kTwoPi / static_cast<double>(count);
  const std::vector<ShellCell> fitted = row;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = nextSeen(fitted, i), steps = next - i;
    if (!fitted[i].seen() || steps == count) continue;
    const double arc = static_cast<double>(steps) * step;
    if (steps == 1 && isNear(fitted[i], fitted[next % count], arc * usual.radius)) continue;
    ShellArc at = usual;
    at.from = usual.from + static_cast<double>(i) * step, at.to = at.from + arc;
    at.z_from = z[i], at.z_to = z[next % count], at.steps = steps;
    at.first = fitted[i], at.last = fitted[next % count];
    const auto between = traceShell(ring, at);
    if (!between) continue;
    for (std::size_t k = i; k < next; ++k) {
      if (k > i) row[k % count] = (*between)[k - i - 1];
      row[k % count].runs_on = true;
    }
  }
}

/// Takes out cells beside which the shell is seen, but jumps: the edge of something before it. What was traced is a
/// dent or a peaked weld only where it is seen on both sides.
void dropJumps(std::vector<ShellCell>& row, double arc) {
  const std::size_t count = row.size();
  const std::vector<ShellCell> all = row;
  for (std::size_t i = 0; i < count; ++i) {
    const ShellCell &before = all[(i + count - 1) % count], &after = all[(i + 1) % count];
    if (!all[i].seen() || !(before.seen() || after.seen())) continue;
    if (before.seen() && after.seen() && (before.runs_on || all[i].runs_on)) continue;
    if (isNear(before, all[i], arc) || isNear(all[i], after, arc)) continue;  // not to what is not seen: NaN
    row[i] = {};
    row[i].doubted = all[i].radius;
    row[(i + count - 1) % count].runs_on = false;
  }
}

}  // namespace

ShellGrid fitShellGrid(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                       const ShellOptions& options) {
  ShellGrid grid;
  const double step = kTwoPi / static_cast<double>(stations.size());
  grid.step = step * circle.radius;
  std::vector<double> elevations;
  for (const Station& s : stations) elevations.push_back(s.z);
  elevations = filledUp(elevations);
  std::vector<std::vector<ShellCell>> rows(bands.heights().size());
  forEachIndex(rows.size(), 0, [&](std::size_t k) {
    const Points points = bands.points(k);
    if (points.size() < kPlenty) return;
    const PolarRing ring(points, circle.center);
    const ShellOutline outline = outlineBand(ring, circle.radius);
    rows[k].resize(stations.size());
    std::vector<double> z;
    for (const double elevation : elevations) z.push_back(elevation + bands.heights()[k]);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (stations[i].reason == Unmeasured::OffCircle) continue;  // another wall
      rows[k][i] = fitCell(ring, outline, {stations[i].direction, z[i], circle.radius}, step, options.half_band);
    }
    dropPoor(rows[k]);
    ShellArc arc{};
    arc.from = stations.front().direction, arc.half_band = options.half_band;
    arc.radius = circle.radius, arc.noise = outline.noise;
    traceRow(ring, z, arc, rows[k]);
    dropJumps(rows[k], grid.step);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (stations[i].reason == Unmeasured::OffCircle) rows[k][i] = {};
    }
  });
  dropPoorRows(rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::none_of(rows[k].begin(), rows[k].end(), [](const ShellCell& cell) { return cell.seen(); })) continue;
    grid.heights.push_back(bands.heights()[k]);
    grid.cells.push_back(std::move(rows[k]));
  }
  return grid;
}

void keepConnected(ShellGrid& grid) {
  if (grid.cells.empty()) return;
  const std::size_t count = grid.cells.front().size();
  Parts parts(grid.cells.size() * count);
  for (std::size_t k = 0; k < grid.cells.size(); ++k) joinAlong(grid, k, parts);
  for (std::size_t i = 0; i < count; ++i) joinUp(grid, i, parts);
  std::vector<std::size_t> sizes(grid.cells.size() * count, 0);
  for (std::size_t c = 0; c < sizes.size(); ++c) sizes[parts.of(c)] += grid.cells[c / count][c % count].seen();
  const auto largest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    ShellCell& cell = grid.cells[c / count][c % count];
    if (cell.seen() && parts.of(c) != largest) cell = {};
  }
}

}  // namespace tank_datum
