#include "foot/foot_banks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/parallel.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/shell_below.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kNear = 5.0 * kDegree;  ///< within which a datum does little

/// Heights above the station's elevation against the distance from the shell, in bins alike to the end of the reach;
/// NaN where too few points lie [m].
using Section = std::vector<double>;

/// The section of a station and its neighbours, each relative to its own elevation.
Section sectionAround(const Foot& foot, const std::vector<double>& levels, std::size_t station, std::size_t bins) {
  constexpr std::size_t kBeside = 3, kFewest = 3,
                        kMost = 300;  // stations to either side, points of a bin, of a station
  constexpr double kHigh = 0.3;       // of the reach
  const std::size_t count = levels.size();
  std::vector<std::vector<double>> heights(bins);
  for (std::size_t k = 0; k <= 2 * kBeside; ++k) {
    const std::size_t i = (station + count + k - kBeside) % count;
    if (!std::isfinite(levels[i])) continue;
    const std::vector<FootPoint>& points = foot.points[i];
    for (std::size_t p = 0; p < points.size(); p += points.size() / kMost + 1) {
      const double height = points[p].z - levels[i], bin = points[p].d / foot.reach * static_cast<double>(bins);
      if (bin < 0.0 || bin >= static_cast<double>(bins) || std::abs(height) > kHigh * foot.reach) continue;
      heights[static_cast<std::size_t>(bin)].push_back(height);
    }
  }
  Section section;
  for (const auto& bin : heights) section.push_back(bin.size() < kFewest ? kUnknown : median(bin));
  return section;
}

/// What sections show round the ring, bin by bin: their median, and how far they usually lie off it.
struct UsualSection {
  Section height, spread;
  std::size_t seen = 0, shared = 0;  ///< bins that a few sections show at least, and half of them

  /// Whether sections show the same bins, mostly.
  bool isWhole() const { return 2 * shared > seen; }
};

/// Of the quartiles the nearer counts: soil over more than a quarter of the ring makes the lower one its own.
/// @param tells  which of the sections say what is usual
/// @param first  bin, before which the surface itself lies
UsualSection usualOf(const std::vector<Section>& sections, const std::vector<bool>& tells, std::size_t first,
                     std::size_t bins, double noise) {
  constexpr std::size_t kFewest = 10;   // sections of a bin
  constexpr double kShare = 0.25;       // and of those there are
  constexpr double kQuartile = 0.6745;  // of a normal distribution
  double known = 0.0;
  for (std::size_t i = 0; i < sections.size(); ++i) known += tells[i] && !sections[i].empty() ? 1.0 : 0.0;
  UsualSection usual{Section(bins, kUnknown), Section(bins, kUnknown)};
  for (std::size_t b = first; b < bins; ++b) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const Section& s = sections[i];
      if (tells[i] && !s.empty() && std::isfinite(s[b])) heights.push_back(s[b]);
    }
    usual.seen += heights.size() >= kFewest ? 1 : 0;
    usual.shared += heights.size() >= kFewest && 2.0 * static_cast<double>(heights.size()) > known ? 1 : 0;
    if (static_cast<double>(heights.size()) < std::max<double>(kFewest, kShare * known)) continue;
    usual.height[b] = median(heights);
    const double below = usual.height[b] - quantile(heights, 0.25), above = quantile(heights, 0.75) - usual.height[b];
    usual.spread[b] = std::hypot(noise, std::min(below, above) / kQuartile);
  }
  return usual;
}

/// The first bin that the surface itself does not reach into, nor the blur of a lip's edge.
std::size_t firstBeyond(const Foot& foot, const FootProfile& surface, std::size_t bins) {
  constexpr double kFirst = 0.12;  // of the reach, where the surface goes on
  const double lip = surface.surface == Surface::AnnularPlate ? (surface.edge + surface.blur) / foot.reach : 0.0;
  constexpr double kRounding = 1e-9;
  return static_cast<std::size_t>(std::ceil(std::max(kFirst, lip) * static_cast<double>(bins) - kRounding));
}

/// The sections of all stations, and what is usual among them.
struct RingSections {
  std::vector<Section> own;
  UsualSection usual;
};

/// In bins as narrow as the scan's rows allow: where these lie so far apart that one station shows a bin and the next
/// does not, few show the same.
/// @param tells  which stations say what is usual
RingSections sectionsOf(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels,
                        const std::vector<bool>& tells) {
  constexpr double kNoise = 0.002;  // of the reach: what medians of bins scatter by at least
  constexpr std::array<std::size_t, 3> kBins{25, 12, 6};
  RingSections finest;
  for (const std::size_t bins : kBins) {
    RingSections ring{std::vector<Section>(levels.size()), {}};
    forEachIndex(levels.size(), 0, [&](std::size_t i) {
      if (std::isfinite(levels[i])) ring.own[i] = sectionAround(foot, levels, i, bins);
    });
    ring.usual = usualOf(ring.own, tells, firstBeyond(foot, surface, bins), bins, kNoise * foot.reach);
    if (ring.usual.isWhole()) return ring;
    if (finest.own.empty()) finest = std::move(ring);
  }
  return finest;
}

/// How far a section lies below the usual one, where that is more than chance explains, else 0; NaN where too little of
/// it is seen to tell [m].
double depthBelow(const Section& section, const UsualSection& usual, double least) {
  constexpr double kStands = 3.0;
  constexpr int kFewest = 2;  // bins
  double weights = 0.0, below = 0.0, spread = 0.0;
  int bins = 0;
  for (std::size_t b = 0; b < section.size(); ++b) {
    if (!std::isfinite(section[b]) || !std::isfinite(usual.height[b])) continue;
    const double weight = 1.0 / (usual.spread[b] * usual.spread[b]);
    weights += weight, below += weight * (usual.height[b] - section[b]), spread += weight * usual.spread[b];
    ++bins;
  }
  if (bins < kFewest) return kUnknown;
  return below > std::max(kStands * spread, least * weights) ? below / weights : 0.0;
}

/// The elevation nearest to a station on one side, and how many stations away; 0: none is near.
struct Beside {
  double level = kUnknown;
  std::size_t away = 0;
};

/// @param step  +1 or -1: the side that is looked at, up to `near` stations on
Beside besideOf(std::size_t station, int step, const std::vector<double>& levels, const std::vector<char>& leave_out,
                std::size_t near) {
  const std::size_t count = levels.size();
  for (std::size_t away = 1; away <= near; ++away) {
    const std::size_t i = (station + (step > 0 ? away : count - away)) % count;
    if (leave_out[i] == 0 && std::isfinite(levels[i])) return {levels[i], away};
  }
  return {};
}

/// How far a run of stations rises above the line between those beside it [m]; infinite where none is near.
/// @param leave_out  stations that are no measure of it
double riseOf(const RingRun& run, const std::vector<double>& levels, const std::vector<char>& leave_out,
              std::size_t near) {
  const std::size_t count = levels.size();
  Beside before = besideOf(run.first % count, -1, levels, leave_out, near);
  Beside after = besideOf(run.last % count, +1, levels, leave_out, near);
  if (before.away == 0 && after.away == 0) return std::numeric_limits<double>::infinity();
  if (before.away == 0) before = {after.level, 1};
  if (after.away == 0) after = {before.level, 1};
  const double length = static_cast<double>(run.last - run.first + before.away + after.away);
  double rise = 0.0;
  for (std::size_t i = run.first; i <= run.last; ++i) {
    if (!std::isfinite(levels[i % count])) continue;
    const double along = static_cast<double>(i - run.first + before.away) / length;
    rise = std::max(rise, levels[i % count] - before.level - along * (after.level - before.level));
  }
  return rise;
}

/// What the shell beside the end of a run says: whether it is seen to go on below the run's elevation. Where it is seen
/// by few points at each station, all tell it together; a foot that lies not much lower ends what there is of it.
enum class Says { Nothing, GoesOn, Ends };

Says shellBeside(const Foot& foot, std::size_t end, int step, const std::vector<double>& levels) {
  constexpr std::size_t kFewest = 3;  // stations whose shell is seen
  constexpr double kAllowed = 0.01;   // of the reach
  constexpr double kDepth = 0.02;     // of the reach: how much of it is looked at
  constexpr double kFalls = 0.005;    // along the shell, twice what the codes allow: a dip beside [m/m]
  const std::size_t count = levels.size(), near = foot.stationsIn(kNear);
  std::size_t seen = 0, below = 0;
  ShellCounts together;
  for (std::size_t away = 1; away <= near; ++away) {
    const std::size_t i = (end + (step > 0 ? away : count - away)) % count;
    if (!foot.shell_seen[i] || std::isfinite(levels[i])) continue;
    const double lower = kAllowed * foot.reach + kFalls * static_cast<double>(away) * foot.arc();
    const FootFit level = levelAt(foot, levels[end] - lower, 0.0);
    const ShellCounts counts = countShell(foot, i, level, leastBelow(foot, level) + kDepth * foot.reach);
    ++seen;
    below += counts.isGoodPart() ? 1 : 0;
    together.add(counts);
  }
  return seen < kFewest ? Says::Nothing : 2 * below > seen && together.goOn() ? Says::GoesOn : Says::Ends;
}

}  // namespace

std::vector<bool> findBanks(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels,
                            const std::vector<bool>& stood) {
  constexpr double kLeast = 0.008;  // of the reach
  constexpr double kShareUp = 0.5;  // of what it hides is what a bank rises by
  const std::size_t count = levels.size(), near = 2 * foot.stationsIn(kNear);
  const RingSections ring = sectionsOf(foot, surface, levels, stood);
  std::vector<double> depths(count, 0.0);
  std::vector<char> lower(count, 0), no_measure(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    depths[i] = depthBelow(ring.own[i], ring.usual, kLeast * foot.reach);
    lower[i] = depths[i] > 0.0 ? 1 : 0;
    no_measure[i] = depths[i] == 0.0 ? 0 : 1;  // one of which nothing is known may stand on the same bank
  }
  std::vector<bool> banks(count, false);
  for (const RingRun& run : runsRound(lower, near)) {
    double depth = 0.0;
    for (std::size_t i = run.first; i <= run.last; ++i) depth = std::max(depth, depths[i % count]);
    if (riseOf(run, levels, no_measure, near) < kShareUp * depth) continue;
    for (std::size_t i = run.first; i <= run.last; ++i) banks[i % count] = std::isfinite(levels[i % count]);
  }
  return banks;
}

std::vector<bool> findHangingRuns(const Foot& foot, const std::vector<double>& levels) {
  constexpr std::size_t kOneEnd = 6, kBothEnds = 2;  // longer parts of the ring are no banks, with that many ends seen
  const std::size_t count = levels.size();
  std::vector<char> known(count);
  for (std::size_t i = 0; i < count; ++i) known[i] = std::isfinite(levels[i]) ? 1 : 0;
  std::vector<bool> hanging(count, false);
  for (const RingRun& run : runsRound(known, foot.stationsIn(kNear))) {
    const Says before = shellBeside(foot, run.first % count, -1, levels);
    const Says after = shellBeside(foot, run.last % count, +1, levels);
    const bool either = before == Says::GoesOn || after == Says::GoesOn;
    const bool neither = before != Says::Ends && after != Says::Ends;
    if (!either || run.last - run.first >= count / (neither ? kBothEnds : kOneEnd)) continue;
    for (std::size_t i = run.first; i <= run.last; ++i) hanging[i % count] = known[i % count] != 0;
  }
  return hanging;
}

}  // namespace tank_datum
