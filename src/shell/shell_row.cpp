#include "shell/shell_row.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "shell/shell_doubts.h"
#include "shell/shell_edges.h"
#include "shell/shell_trace.h"

namespace tank_datum {
namespace {

constexpr std::size_t kPlenty = 40;                // points for four unknowns
constexpr double kWantedSigma = 0.5 * kGoodSigma;  // a cell borrows points from its neighbours until it is this good
constexpr double kWidestArc = 0.4;   // but no further: a wave of 3 m is a parabola over twice that to 0.2 % [m]
constexpr double kSteepest = 0.2;    // of a shell; a roof is flatter [m/m]
constexpr double kBesideEdge = 0.1;  // a horizontal edge is looked for as far on either side [m]

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
ShellCell fitCell(const PolarRing& ring, const ShellOutline& outline, const ShellEdges& edges, const CellPlace& at,
                  double step, double half_band) {
  const double own = std::min(step, kOneDegree);
  const double widest = std::max(own, std::min(kWidestArc / at.radius, kPi));  // no more than the ring either way
  const double back = edges.runsOn(at.direction, -1, widest), on = edges.runsOn(at.direction, 1, widest);
  const ShellHeights band{-half_band, half_band};
  const ShellLine wide = fitShellLine(ring, outline, {at.direction, widest, at.z, band, back, on});
  ShellCell cell;
  if (wide.points < kPlenty) return cell;
  for (double half = 0.5 * own;; half *= 1.5) {
    const ShellLine line = fitShellLine(ring, outline, {at.direction, half, at.z, band, back, on});
    const bool stands = line.isSupportedWithin(own * at.radius) && std::abs(line.lean) < kSteepest;
    if (line.points >= kPlenty && stands) {
      cell = {line.radius, sigmaOf(line, wide.noise), std::max(1.0, 2.0 * half / step), line.points};
    }
    if (cell.sigma < kWantedSigma || 1.5 * half > widest) return cell;
  }
}

/// Takes out the cells whose points do not agree on a surface as the others' do: seen past the edge of something.
void dropPoor(std::vector<ShellCell>& row) {
  constexpr double kPoor = 4.0;  // times the usual standard error
  const double worst = std::max(kGoodSigma, kPoor * usualSigma(row));
  for (ShellCell& cell : row) {
    if (cell.sigma > worst) cell = {};
  }
}

/// Stations at a horizontal edge, where less than an eighth of the ring has one: of something put upon the shell, and
/// not of its courses.
std::vector<std::size_t> horizontalEdges(const PolarRing& ring, const std::vector<CellPlace>& places, double half_band,
                                         double noise) {
  const double step = kTwoPi / static_cast<double>(places.size());
  std::vector<std::size_t> at_edge;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double half = std::max(0.5 * step, std::min(kBesideEdge / places[i].radius, kPi));
    if (stepsUpwards(ring, {places[i].direction, half, places[i].z, half_band}, noise)) at_edge.push_back(i);
  }
  if (8 * at_edge.size() >= places.size()) at_edge.clear();
  return at_edge;
}

/// Whether two stations of a row, so many steps apart, may be one shell by their radii.
bool isNear(const ShellCell& a, const ShellCell& b, double arc) { return mayBeOne(a, b, bendAlong(arc)); }

/// Traces the shell from station to station where lines cannot be fitted to it, or lie apart: over a dent or a peaked
/// weld narrower than they are.
/// @param z  of the row at every station [m]
void traceRow(const PolarRing& ring, const ShellEdges& edges, const std::vector<double>& z, const ShellArc& usual,
              std::vector<ShellCell>& row) {
  const std::size_t count = row.size();
  const double step = kTwoPi / static_cast<double>(count);
  const std::vector<ShellCell> fitted = row;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = nextSeen(fitted, i), steps = next - i;
    if (!fitted[i].seen() || steps == count) continue;
    const double arc = static_cast<double>(steps) * step, from = usual.from + static_cast<double>(i) * step;
    row[i].stepped = edges.stepsBetween(from, from + arc);
    if (steps == 1 && isNear(fitted[i], fitted[next % count], arc * usual.radius)) continue;
    ShellArc at = usual;
    at.from = from, at.to = from + arc;
    at.z_from = z[i], at.z_to = z[next % count], at.steps = steps;
    at.first = fitted[i], at.last = fitted[next % count];
    const ShellTrace trace = traceShell(ring, at);
    const bool runs_on = trace.runs_on && row[i].stepped == 0.0;
    if (trace.stepped != 0.0) row[i].stepped = trace.stepped;
    for (std::size_t k = i; runs_on && k < next; ++k) {
      if (k > i) row[k % count] = trace.stations[k - i - 1];
      row[k % count].runs_on = true;
    }
  }
}

/// Takes out what stands before the shell or is put upon it: between two edges at which the radius jumps towards where
/// the shell is seen from and back, and not as wide as an eighth of the ring. What is put upon that is taken out first.
bool dropObjects(std::vector<ShellCell>& row, double step, Side side) {
  constexpr double kThickest = 0.025, kWidestPad = 3.0;  // of the shell's own plates and what is welded upon them [m]
  const std::size_t count = row.size(), pad = static_cast<std::size_t>(kWidestPad / step);
  const std::vector<ShellCell> all = row;
  bool dropped = false;
  std::size_t first = 2 * count;  // of what may be an object; none yet
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const ShellCell& cell = all[i % count];
    const std::size_t steps = nextSeen(all, i % count) - i % count;
    if (!cell.seen() || runsToNext(all, i % count, steps, step)) continue;
    const double jump = all[(i + steps) % count].radius - cell.radius;
    const bool towards = side == Side::Inside ? jump < 0.0 : jump > 0.0;
    const std::size_t widest = std::abs(jump) < kThickest ? std::min(count / 8, pad) : count / 8;
    if (!towards && first <= i && i - first < widest) {
      for (std::size_t k = first; k <= i; ++k) row[k % count] = {};
      dropped = true;
    }
    first = towards ? i + steps : 2 * count;
  }
  return dropped;
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

/// The points of a row that are about its height at the stations [m].
PolarRing atHeight(const PolarRing& ring, const std::vector<Station>& stations, const std::vector<double>& z,
                   double half_band) {
  const double step = kTwoPi / static_cast<double>(stations.size());
  PolarPoints near;
  for (const PolarPoint& p : ring.points()) {
    const double ahead = std::remainder(p.azimuth - stations.front().direction, kTwoPi);
    const auto station = static_cast<std::size_t>(std::round((ahead < 0.0 ? ahead + kTwoPi : ahead) / step));
    if (std::abs(p.z - z[station % stations.size()]) <= half_band) near.push_back(p);
  }
  return PolarRing(std::move(near));
}

}  // namespace

double usualSigma(const std::vector<ShellCell>& row) {
  std::vector<double> sigmas;
  for (const ShellCell& cell : row) {
    if (cell.seen()) sigmas.push_back(cell.sigma);
  }
  return median(std::move(sigmas));
}

bool mayBeOne(const ShellCell& a, const ShellCell& b, double bend) {
  return std::abs(a.radius - b.radius) <= bend + 4.0 * std::hypot(a.sigma, b.sigma);
}

std::size_t nextSeen(const std::vector<ShellCell>& row, std::size_t i) {
  std::size_t next = i + 1;
  while (next < i + row.size() && !row[next % row.size()].seen()) ++next;
  return next;
}

bool runsToNext(const std::vector<ShellCell>& row, std::size_t i, std::size_t steps, double step) {
  const ShellCell &cell = row[i], &next = row[(i + steps) % row.size()];
  if (cell.runs_on) return true;
  const double change = next.radius - cell.radius;
  return 2.0 * std::abs(change - cell.stepped) >= std::abs(change) &&
         isNear(cell, next, static_cast<double>(steps) * step);
}

std::vector<ShellCell> fitShellRow(const Points& points, const std::vector<Station>& stations, const Circle& circle,
                                   const std::vector<double>& z, const ShellRowOptions& options) {
  const std::size_t count = stations.size();
  const double step = kTwoPi / static_cast<double>(count);
  const PolarRing ring = atHeight(PolarRing(points, circle.center), stations, z, options.half_band);
  if (ring.points().size() < kPlenty) return {};
  const ShellOutline outline = outlineBand(ring, circle.radius);
  const ShellEdges edges(ring, outline, circle.radius);
  std::vector<ShellCell> row(count);
  std::vector<CellPlace> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({stations[i].direction, z[i], circle.radius});
  const auto isOtherWall = [&](std::size_t i) { return stations[i].reason == Unmeasured::OffCircle; };
  for (std::size_t i = 0; i < count; ++i) {
    if (isOtherWall(i)) continue;
    row[i] = fitCell(ring, outline, edges, places[i], step, options.half_band);
  }
  const std::vector<std::size_t> at_edge = horizontalEdges(ring, places, options.half_band, outline.noise);
  const auto dropEdges = [&] {
    for (const std::size_t i : at_edge) row[i] = {};
  };
  dropEdges();
  dropPoor(row);
  ShellArc arc{};
  arc.from = stations.front().direction, arc.half_band = options.half_band;
  arc.radius = circle.radius, arc.noise = outline.noise;
  traceRow(ring, edges, z, arc, row);
  dropEdges();
  while (dropObjects(row, step * circle.radius, options.side)) {
  }
  dropJumps(row, step * circle.radius);
  for (std::size_t i = 0; i < count; ++i) {
    if (isOtherWall(i)) row[i] = {}, row[i].doubted = outline.at(stations[i].direction);  // or a dent of the shell
  }
  doubtBetween(outline, edges, stations, row);
  return row;
}

}  // namespace tank_datum
