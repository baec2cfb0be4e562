#include "foot/foot_rises.h"

#include <algorithm>
#include <cmath>

#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_process.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// How many stations beside an arc may lie on what fades into it.
std::size_t fadingStations(const Foot& foot) {
  constexpr double kReaches = 2.0;            // of the ring: how long soil takes to fade
  constexpr double kWidest = 20.0 * kDegree;  // on small tanks
  return foot.stationsIn(std::min(kWidest, kReaches * foot.reach / foot.radius));
}

/// Arcs in which the foundation is not seen, and something else is.
std::vector<RingRun> coveredArcs(const FootOutliers& outliers) {
  const std::size_t count = outliers.reasons.size();
  const auto is = [&](std::size_t i, Unmeasured reason) { return outliers.reasons[i % count] == reason; };
  std::vector<char> unseen;
  for (std::size_t i = 0; i < count; ++i)
    unseen.push_back(is(i, Unmeasured::OtherSurface) || is(i, Unmeasured::Hidden) ? 1 : 0);
  std::vector<RingRun> arcs;
  for (const RingRun& run : runsRound(unseen)) {
    bool other = false;
    for (std::size_t i = run.first; i <= run.last; ++i) other = other || is(i, Unmeasured::OtherSurface);
    if (other) arcs.push_back(run);
  }
  return arcs;
}

/// How many stations on from an end of an arc an island ends that begins near it, with nothing near beyond; 0: none.
/// @param at  the stations on from there
template <typename At>
std::size_t endOfIsland(const Foot& foot, const std::vector<double>& levels, std::size_t fading, const At& at) {
  constexpr double kFar = 5.0 * kDegree;  // beyond where soil fades: of its end, and what is not near
  const std::size_t far = foot.stationsIn(kFar), most = std::min(levels.size() / 2, fading + far);
  std::size_t last = 0;
  for (std::size_t away = 1; away <= std::max(last, fading) + far; ++away) {
    if (std::isfinite(levels[at(away)])) last = away;
    if (last > most) return 0;
  }
  return last;
}

/// The stations beside the ends of arcs, the nearest to it first, that may lie on what fades into it.
/// @param islands  with all of islands among them, which would say themselves that they do not rise
std::vector<std::vector<std::size_t>> besideArcs(const Foot& foot, const std::vector<RingRun>& arcs,
                                                 const std::vector<double>& levels, bool islands) {
  const std::size_t count = levels.size(), fading = std::min(count / 2, fadingStations(foot));
  std::vector<std::vector<std::size_t>> sides;
  for (const RingRun& arc : arcs) {
    for (const bool ahead : {false, true}) {
      const auto at = [&](std::size_t away) { return (ahead ? arc.last + away : arc.first + count - away) % count; };
      const std::size_t stations = islands ? std::max(fading, endOfIsland(foot, levels, fading, at)) : fading;
      sides.emplace_back();
      for (std::size_t away = 1; away <= stations; ++away) sides.back().push_back(at(away));
    }
  }
  return sides;
}

/// Levels without those beside arcs.
std::vector<double> withoutSides(std::vector<double> levels, const std::vector<std::vector<std::size_t>>& sides) {
  for (const auto& side : sides) {
    for (const std::size_t i : side) levels[i] = kUnknown;
  }
  return levels;
}

double knownOf(const std::vector<double>& levels) { return static_cast<double>(finiteOf(levels).size()); }

/// Levels that are compared with what those farther away say of them.
struct Compared {
  const std::vector<double>&levels, &sigmas;
  const RingProcess& expected;

  /// How many of the last of some stations lie above that together; 0: none do.
  /// @param passed  their places beside an arc's end
  std::size_t risen(const std::vector<std::size_t>& beside, const std::vector<std::size_t>& passed) const {
    constexpr double kFar = 3.0;      // standard errors
    constexpr std::size_t kMost = 6;  // stations
    double off = 0.0, own = 0.0, others = 0.0;
    for (std::size_t n = 1; n <= std::min(kMost, passed.size()); ++n) {
      const std::size_t i = beside[passed[passed.size() - n]];
      off += levels[i] - expected.value[i];
      own += sigmas[i] * sigmas[i] + expected.nugget * expected.nugget;
      others += expected.sigmaIfShaped(i);  // what they share does not become less; waves do not rise as soil does
      if (off > kFar * std::sqrt(own + others * others)) return n;
    }
    return 0;
  }

  /// Marks those of the stations beside an arc's end that rise towards it.
  void mark(const std::vector<std::size_t>& beside, std::vector<bool>& rises) const {
    std::vector<std::size_t> passed;
    for (std::size_t k = beside.size(); k-- > 0;) {
      if (!std::isfinite(levels[beside[k]])) continue;
      passed.push_back(k);
      const std::size_t last = risen(beside, passed);
      if (last == 0) continue;
      for (std::size_t nearer = 0; nearer <= passed[passed.size() - last]; ++nearer) rises[beside[nearer]] = true;
      return;
    }
  }
};

}  // namespace

std::vector<bool> findRises(const Foot& foot, const FootOutliers& outliers, const std::vector<double>& levels,
                            const std::vector<double>& sigmas) {
  constexpr double kLittle = 0.002;  // of the reach: what the datum itself does at least beside an arc
  constexpr double kMost = 0.5;      // of the levels: islands that are more are the ring
  const std::vector<RingRun> arcs = coveredArcs(outliers);
  std::vector<bool> rises(levels.size(), false);
  if (arcs.empty()) return rises;
  const auto compare = [&](const std::vector<std::vector<std::size_t>>& sides, double least, double most) {
    const std::vector<double> far = withoutSides(levels, sides);
    if (knownOf(far) < (1.0 - most) * knownOf(levels)) return;
    const RingProcess expected = followRing(far, sigmas, least * foot.reach);
    if (!expected.valid()) return;
    for (const auto& side : sides) Compared{levels, sigmas, expected}.mark(side, rises);
  };
  compare(besideArcs(foot, arcs, levels, false), kLittle, 1.0);
  compare(besideArcs(foot, arcs, levels, true), kDip, kMost);
  return rises;
}

}  // namespace tank_datum
