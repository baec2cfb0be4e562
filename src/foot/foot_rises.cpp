#include "foot/foot_rises.h"

#include <algorithm>
#include <cmath>

#include "core/ring_runs.h"
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

/// The stations beside one end of an arc, the nearest first.
std::vector<std::size_t> besideEnd(const RingRun& arc, bool ahead, std::size_t stations, std::size_t count) {
  std::vector<std::size_t> beside;
  for (std::size_t away = 1; away <= stations; ++away)
    beside.push_back((ahead ? arc.last + away : arc.first + count - away) % count);
  return beside;
}

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
      others += expected.sigma[i];  // what they share does not become less
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
  constexpr double kLittle = 0.002;  // of the reach: what the datum itself does beside an arc at least
  const std::size_t count = levels.size(), stations = std::min(count / 2, fadingStations(foot));
  std::vector<bool> rises(count, false);
  std::vector<std::vector<std::size_t>> sides;
  for (const RingRun& arc : coveredArcs(outliers)) {
    for (const bool ahead : {false, true}) sides.push_back(besideEnd(arc, ahead, stations, count));
  }
  if (sides.empty()) return rises;
  std::vector<double> far = levels;
  for (const auto& side : sides) {
    for (const std::size_t i : side) far[i] = kUnknown;
  }
  const RingProcess expected = followRing(far, sigmas, kLittle * foot.reach);
  if (!expected.valid()) return rises;
  for (const auto& side : sides) Compared{levels, sigmas, expected}.mark(side, rises);
  return rises;
}

}  // namespace tank_datum
