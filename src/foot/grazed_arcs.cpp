#include "foot/grazed_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "foot/hidden_strip.h"

namespace tank_datum {
namespace {

constexpr std::size_t kStrips = 30;

/// Sums over points, against their distance from the shell.
struct LineSums {
  double n = 0, d = 0, z = 0, dd = 0, dz = 0, zz = 0;

  void add(double at, double height) { add({1.0, at, height, at * at, at * height, height * height}); }
  void add(const LineSums& o) { n += o.n, d += o.d, z += o.z, dd += o.dd, dz += o.dz, zz += o.zz; }
  double distance() const { return d / n; }
  double height() const { return z / n; }
  double squares() const { return dd - d * d / n; }
  double slope() const { return (dz - d * z / n) / squares(); }
  double sigmaSlope() const {
    const double misfit = std::max(0.0, zz - z * z / n - slope() * slope() * squares());
    return std::sqrt(misfit / std::max(1.0, n - 2.0) / squares());
  }
};

/// What is seen in a strip along the shell.
struct StripSeen {
  double points = 0;
  LineSums surface, higher;  ///< of what lies on the stations' surface, and above

  void add(const StripSeen& o) { points += o.points, surface.add(o.surface), higher.add(o.higher); }
};

/// What is seen at a station or in an arc, from the shell outwards.
using StripsSeen = std::array<StripSeen, kStrips>;

StripsSeen stripsAt(const std::vector<FootPoint>& points, double level, double slope, const StripScales& scales) {
  StripsSeen strips{};
  for (const FootPoint& p : points) {
    const double height = p.z - level - slope * p.d;
    const std::size_t number = scales.stripAt(p.d, kStrips);
    if (number == kStrips) continue;
    StripSeen& strip = strips[number];
    strip.points += 1.0;
    if (std::abs(height) < scales.within) strip.surface.add(p.d, height);
    if (height > scales.higher) strip.higher.add(p.d, height);
  }
  return strips;
}

/// Points of a strip, usually.
double usualPoints(const StripsSeen& strips) {
  std::vector<double> points;
  for (const StripSeen& strip : strips) {
    if (strip.points > 0.0) points.push_back(strip.points);
  }
  return median(std::move(points));
}

/// The first strip in which most of what is seen lies higher than the surface; all: none.
std::size_t edgeOf(const StripsSeen& strips, double usual) {
  constexpr double kSeen = 0.5;  // of the usual number of points, and of them
  std::size_t edge = 0;
  while (edge < kStrips &&
         !(strips[edge].points > kSeen * usual && strips[edge].higher.n > kSeen * strips[edge].points))
    ++edge;
  return edge;
}

/// Whether strips beside the shell, how ever many are taken, have fewer points of the surface than strips have usually.
bool areThin(const StripsSeen& strips, std::size_t edge, double usual) {
  constexpr double kThin = 0.5;
  constexpr std::size_t kFewest = 2;  // a lip may be hidden but for so many
  double sum = 0.0;
  for (std::size_t k = 0; k < edge; ++k) {
    sum += strips[k].surface.n;
    if (k + 1 >= kFewest && sum >= kThin * usual * static_cast<double>(k + 1)) return false;
  }
  return edge >= kFewest;
}

/// Whether what is seen of the surface rises towards the edge.
bool rises(const StripsSeen& strips, std::size_t edge) {
  constexpr double kAlong = 0.3;   // of the line to the edge, at least
  constexpr double kChance = 2.0;  // standard errors
  LineSums before, beyond;
  for (std::size_t k = 0; k + 1 < edge; ++k) before.add(strips[k].surface);
  for (std::size_t k = edge; k < std::min(edge + 2, kStrips); ++k) beyond.add(strips[k].higher);
  const double line = (beyond.height() - before.height()) / (beyond.distance() - before.distance());
  return before.slope() > std::max(kAlong * line, kChance * before.sigmaSlope());
}

bool isGrazedArc(const StripsSeen& strips) {
  const double usual = usualPoints(strips);
  const std::size_t edge = edgeOf(strips, usual);
  return edge < kStrips && areThin(strips, edge, usual) && rises(strips, edge);
}

}  // namespace

std::vector<bool> findGrazedArcs(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept) {
  constexpr double kArc = 7.0 * kDegree;  // to either side, that is looked at together
  const StripScales scales = stripScales(foot, pass);
  const std::vector<double> elevations = elevationsOf(kept), levels = filledUp(elevations);
  const std::vector<bool> about = closeTo(foot, elevations);
  const std::size_t count = kept.size(), near = foot.stationsBeside(kArc);
  std::vector<StripsSeen> own(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (about[i]) own[i] = stripsAt(foot.points[i], levels[i], pass.priors.slope[i], scales);
  });
  std::vector<char> grazed(count, 0);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (!kept[i].valid()) return;
    StripsSeen arc{};
    for (std::size_t k = i + count - near; k <= i + count + near; ++k) {
      for (std::size_t strip = 0; strip < kStrips; ++strip) arc[strip].add(own[k % count][strip]);
    }
    grazed[i] = isGrazedArc(arc);
  });
  return {grazed.begin(), grazed.end()};
}

}  // namespace tank_datum
