#include "foot/grazed_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "fit/line_sums.h"
#include "foot/hidden_strip.h"
#include "foot/slanting_beams.h"

namespace tank_datum {
namespace {

constexpr std::size_t kStrips = 30;     // beside the shell, which an edge may hide
constexpr std::size_t kAllStrips = 48;  // to the end of the section
constexpr double kLip = 0.05;           // its slope, at most [m/m]

/// What is seen in a strip along the shell.
struct StripSeen {
  LineSums all;              ///< over the stations' elevation
  LineSums surface, higher;  ///< of what lies on their surface, and above; over its slope

  void add(const StripSeen& o) { all.add(o.all), surface.add(o.surface), higher.add(o.higher); }
};

/// What is seen in strips from the shell outwards.
using StripsSeen = std::array<StripSeen, kAllStrips>;

/// What is seen at a station or in an arc.
struct ArcSeen {
  StripsSeen strips{};
  double on_shell = 0;  ///< points that tell how steeply rays come

  void add(const ArcSeen& o) {
    for (std::size_t k = 0; k < kAllStrips; ++k) strips[k].add(o.strips[k]);
    on_shell += o.on_shell;
  }
};

ArcSeen seenAt(const Foot& foot, const FootPass& pass, std::size_t station, double level, const StripScales& scales) {
  const FootProfile& profile = pass.sections.at(station);
  ArcSeen seen;
  for (const FootPoint& p : foot.points[station]) {
    if (isOnShell(p, profile, level, foot.reach)) seen.on_shell += 1.0;
    const double height = p.z - level - pass.priors.slope[station] * p.d;
    const std::size_t number = scales.stripAt(p.d, kAllStrips);
    if (number == kAllStrips) continue;
    StripSeen& strip = seen.strips[number];
    strip.all.add(p.d, p.z - level);
    if (std::abs(height) < scales.within) strip.surface.add(p.d, height);
    if (height > scales.higher) strip.higher.add(p.d, height);
  }
  return seen;
}

/// Points of a strip, usually.
double usualPoints(const StripsSeen& strips) {
  std::vector<double> points;
  for (std::size_t k = 0; k < kStrips; ++k) {
    if (strips[k].all.n > 0.0) points.push_back(strips[k].all.n);
  }
  return median(std::move(points));
}

/// The first strip that shows a usual number of points, most of them such as are counted; all: none.
template <typename Count>
std::size_t firstOf(const StripsSeen& strips, double usual, const Count& count) {
  constexpr double kSeen = 0.5;  // of the usual number of points, and of them
  std::size_t first = 0;
  while (first < kStrips &&
         !(strips[first].all.n > kSeen * usual && count(strips[first]) > kSeen * strips[first].all.n))
    ++first;
  return first;
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

/// Whether few points rise towards the edge of what lies higher.
bool isThinRise(const StripsSeen& strips, double usual) {
  const std::size_t edge = firstOf(strips, usual, [](const StripSeen& strip) { return strip.higher.n; });
  return edge < kStrips && areThin(strips, edge, usual) && rises(strips, edge);
}

/// Whether a surface that ends within the strips rises more steeply than lips do, and at a good part of the beams' own
/// slope, as none does that they show: beams that meet the edge where it ends and the shell too leave one, as dense as
/// any.
/// @param prior  the slope that heights are taken over [m/m]
bool isAlongBeams(const ArcSeen& arc, double usual, double prior, const StripScales& scales, double reach) {
  constexpr double kAlong = 0.35;     // of the beams' slope
  constexpr double kChance = 3.0;     // standard errors
  constexpr std::size_t kFewest = 3;  // strips
  const std::size_t end =
      firstOf(arc.strips, usual, [](const StripSeen& strip) { return strip.all.n - strip.surface.n; });
  const std::optional<double> beams = steepnessBy(usual / scales.width, arc.on_shell, reach);
  if (end < kFewest || end == kStrips || !beams) return false;
  LineSums surface;
  for (std::size_t k = 0; k < end; ++k) surface.add(arc.strips[k].surface);
  return prior + surface.slope() > std::max({kLip, kAlong * *beams, kChance * surface.sigmaSlope()});
}

/// Whether something is seen farther out than some strips, several times as densely as what lies in them.
/// @param points  of a strip, of those
bool isEdgeBeyond(const StripsSeen& strips, std::size_t count, double points) {
  constexpr std::size_t kTogether = 5;  // strips; rows of a scan lie closer
  constexpr double kTimes = 3.0;
  for (std::size_t k = count; k + kTogether <= kAllStrips; ++k) {
    double sum = 0.0;
    for (std::size_t j = k; j < k + kTogether; ++j) sum += strips[j].all.n;
    if (sum > kTimes * points * static_cast<double>(kTogether)) return true;
  }
  return false;
}

/// Whether what lies beside a shell seen from inside is in line, rises away from it more steeply than lips do, and is
/// far less than rays show of a surface that rises so: beams leave it that meet both the shell and an edge farther off,
/// a coil's or a pipe's, which hides the foot. (A steep floor that is wet is as thin farther out.) Rays that fall by r
/// meet a surface that rises by s with (r - s) times as many points a metre as the shell.
bool isHiddenByEdge(const ArcSeen& arc, const StripScales& scales, double reach) {
  constexpr double kThin = 0.5;       // of the surface's slope: what rays fall by more
  constexpr double kInLine = 0.8;     // of the squares of heights; of a step up it is three quarters
  constexpr std::size_t kFewest = 5;  // strips
  const std::optional<double> of_point = steepnessBy(1.0 / scales.width, arc.on_shell, reach);
  if (!of_point) return false;
  LineSums seen;
  double densest = 0.0;  // points to a strip, in strips from the shell on
  for (std::size_t k = 0; k < kStrips; ++k) {
    seen.add(arc.strips[k].all);
    if (k + 1 < kFewest) continue;
    densest = std::max(densest, seen.n / static_cast<double>(k + 1));
    if (seen.slope() > kLip && seen.explained() > kInLine && densest * *of_point < kThin * seen.slope() &&
        isEdgeBeyond(arc.strips, k + 1, densest))
      return true;
  }
  return false;
}

}  // namespace

std::vector<bool> findGrazedArcs(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept) {
  constexpr double kArc = 7.0 * kDegree;  // to either side, that is looked at together
  const StripScales scales = stripScales(foot, pass);
  const std::vector<double> elevations = elevationsOf(kept), levels = filledUp(elevations);
  const std::vector<bool> about = closeTo(foot, elevations);
  const std::size_t count = kept.size(), near = foot.stationsBeside(kArc);
  std::vector<ArcSeen> own(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (about[i]) own[i] = seenAt(foot, pass, i, levels[i], scales);
  });
  std::vector<char> grazed(count, 0);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (!kept[i].valid()) return;
    ArcSeen arc;
    for (std::size_t k = i + count - near; k <= i + count + near; ++k) arc.add(own[k % count]);
    const double usual = usualPoints(arc.strips);
    const bool is_grazed = isThinRise(arc.strips, usual) || (foot.inside && isHiddenByEdge(arc, scales, foot.reach)) ||
                           isAlongBeams(arc, usual, pass.priors.slope[i], scales, foot.reach);
    grazed[i] = is_grazed ? 1 : 0;
  });
  return {grazed.begin(), grazed.end()};
}

}  // namespace tank_datum
