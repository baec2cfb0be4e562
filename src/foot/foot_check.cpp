#include "foot/foot_check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/least_without.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// Stations that stand, over gaps that are bridged.
std::vector<RingRun> islandsOf(const std::vector<Unmeasured>& reasons, std::size_t far) {
  std::vector<char> stand;
  for (const Unmeasured reason : reasons) stand.push_back(reason == Unmeasured::None ? 1 : 0);
  return runsRound(stand, far);
}

bool isStep(const FootFit& a, const FootFit& b, double arc) {
  constexpr double kSteepest = 0.02;  // of a datum along its shell; ten times what the codes allow [m/m]
  constexpr double kLeast = 0.002;    // a step that matters [m]
  return std::abs(a.z - b.z) > kSteepest * arc + 3.0 * std::hypot(a.sigma, b.sigma) + kLeast;
}

constexpr double kThirdDifference = 1.0 + 9.0 + 9.0 + 1.0;  // its variance over that of one value

struct ThirdDifference {
  double value, variance;
};

void addDifferences(const std::vector<FootFit>& fits, std::size_t lag, std::vector<ThirdDifference>& differences) {
  const std::size_t count = fits.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FootFit *a = &fits[i], *b = &fits[(i + lag) % count], *c = &fits[(i + 2 * lag) % count],
                  *d = &fits[(i + 3 * lag) % count];
    if (!a->valid() || !b->valid() || !c->valid() || !d->valid()) continue;
    differences.push_back(
        {d->z - 3.0 * c->z + 3.0 * b->z - a->z,
         d->sigma * d->sigma + 9.0 * (c->sigma * c->sigma + b->sigma * b->sigma) + a->sigma * a->sigma});
  }
}

/// What is known of the stations while steps are looked for.
struct Stepped {
  const std::vector<FootFit>& fits;
  double arc;  ///< between stations [m]
  std::vector<bool> dropped, kept;

  bool stands(std::size_t i) const { return fits[i].valid() && !dropped[i]; }
  /// A run that is kept may lie as far below those beside it as it likes.
  bool isIntoKept(std::size_t a, std::size_t b) const {
    return kept[a] != kept[b] && (fits[a].z < fits[b].z) == kept[a];
  }
};

/// Where runs begin among stations that are seen: at steps, and beyond gaps over which the level changes by as much as
/// half of the least of them, and by more than codes allow. Where a ring has two surfaces, it goes over to the other
/// where nothing is seen too.
std::vector<char> beginningsOf(const Stepped& ring, const std::vector<std::size_t>& seen) {
  constexpr double kShare = 0.5;
  constexpr double kAllowed = 0.002;  // of a datum along its shell [m/m]
  const std::size_t count = ring.fits.size();
  std::vector<char> begin(seen.size(), 0);
  double least = HUGE_VAL;
  const auto arcOf = [&](std::size_t apart) { return static_cast<double>(apart) * ring.arc; };
  const auto visit = [&](const auto& look) {
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const std::size_t before = seen[(k + seen.size() - 1) % seen.size()], apart = (seen[k] + count - before) % count;
      look(k, before, apart, std::abs(ring.fits[seen[k]].z - ring.fits[before].z));
    }
  };
  visit([&](std::size_t k, std::size_t before, std::size_t apart, double off) {
    if (ring.isIntoKept(seen[k], before) || !isStep(ring.fits[seen[k]], ring.fits[before], arcOf(apart))) return;
    begin[k] = 1;
    least = std::min(least, off);
  });
  visit([&](std::size_t k, std::size_t before, std::size_t apart, double off) {
    if (apart > 1 && off > kShare * least + kAllowed * arcOf(apart) && !ring.isIntoKept(seen[k], before)) begin[k] = 1;
  });
  return begin;
}

/// Runs between steps, none when the ring has no step. Stations not valid or dropped are passed over.
std::vector<StepRun> runsBetweenSteps(const Stepped& ring) {
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < ring.fits.size(); ++i) {
    if (ring.stands(i)) seen.push_back(i);
  }
  const auto at = [&](std::size_t k) { return seen[k % seen.size()]; };
  const std::vector<char> begin = beginningsOf(ring, seen);
  std::vector<StepRun> runs;
  for (const RingRun& between : runsBetween(seen.size(), [&](std::size_t k) { return begin[k] != 0; })) {
    StepRun run;
    for (std::size_t k = between.first; k <= between.last; ++k) run.stations.push_back(at(k));
    run.beside = std::min(ring.fits[at(between.first + seen.size() - 1)].z, ring.fits[at(between.last + 1)].z);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

bool isSameSurface(const std::vector<FootPoint>& points, const FootFit& fit, double prior_slope,
                   const FootProfile& profile) {
  constexpr double kNoise = 3.0;        // times the usual roughness
  constexpr double kBeside = 0.03;      // so far beyond its edge a surface is known to end by the step down [m]
  constexpr double kLeastDrop = 0.003;  // of that step [m]
  constexpr std::size_t kFewestBeside = 6;
  constexpr double kSection = 0.010;  // how far the section beyond may differ in height [m]
  constexpr double kHangs = 0.05;     // so far above what is seen below it: a drip ring, a pipe [m]
  if (std::abs(fit.slope - prior_slope) > kSlopeVaries + 3.0 * fit.sigma_slope) return false;
  if (fit.noise > kNoise * profile.noise) return false;
  struct Beyond {
    double d, off, drop;
  };
  std::vector<Beyond> beyond;
  for (const FootPoint& p : points) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, p.d) / profile.bin);
    if (p.d < profile.edge + profile.blur || bin >= profile.height.size()) continue;
    if (!(profile.spread[bin] <= 2.0 * profile.noise)) continue;  // an upright face has no height of its own
    const double expected = fit.z - profile.offset + profile.height[bin];
    if (!std::isfinite(expected)) continue;
    beyond.push_back({p.d, p.z - expected, profile.offset + profile.slope * p.d - profile.height[bin]});
  }
  const auto in_place = std::count_if(beyond.begin(), beyond.end(),
                                      [&](const Beyond& p) { return std::abs(p.off) <= kSection + 2.0 * fit.sigma; });
  std::vector<double> off, beside, drops;
  for (const Beyond& p : beyond) {
    if (static_cast<std::size_t>(in_place) >= kFewestBeside && p.off > kHangs) continue;
    off.push_back(p.off);
    if (p.d > profile.edge + profile.blur + kBeside) continue;
    beside.push_back(p.off);
    drops.push_back(p.drop);
  }
  const bool ends = beside.size() >= kFewestBeside && median(drops) > kLeastDrop;
  if (ends && median(beside) > 0.5 * median(drops) + 2.0 * fit.sigma) return false;  // soil goes on over the edge
  if (off.size() < 10 || std::abs(median(off)) <= kSection + 2.0 * fit.sigma) return true;
  // what lies beside the edge is in its place: farther out, below a face, it may end sooner than elsewhere
  const auto beside_above = std::count_if(beside.begin(), beside.end(), [](double z) { return z > -kHangs; });
  const auto beside_in_place =
      std::count_if(beside.begin(), beside.end(), [&](double z) { return std::abs(z) <= kSection + 2.0 * fit.sigma; });
  return static_cast<std::size_t>(beside_in_place) >= kFewestBeside && 2 * beside_in_place > beside_above;
}

Steps findSteps(const std::vector<FootFit>& fits, double step, const std::function<bool(const StepRun&)>& is_foot) {
  Stepped ring{fits, step, std::vector<bool>(fits.size(), false), std::vector<bool>(fits.size(), false)};
  for (auto runs = runsBetweenSteps(ring); !runs.empty(); runs = runsBetweenSteps(ring)) {
    const auto shortest = std::min_element(runs.begin(), runs.end(), [](const StepRun& a, const StepRun& b) {
      return a.stations.size() < b.stations.size();
    });
    const auto below = [&](std::size_t i) { return fits[i].z < shortest->beside; };
    const bool dip = !ring.kept[shortest->stations.front()] &&
                     std::all_of(shortest->stations.begin(), shortest->stations.end(), below) && is_foot(*shortest);
    for (const std::size_t i : shortest->stations) (dip ? ring.kept : ring.dropped)[i] = true;
  }
  return {std::move(ring.dropped), std::move(ring.kept)};
}

std::vector<bool> findOutnumberedIslands(const std::vector<Unmeasured>& reasons, std::size_t far) {
  const std::size_t count = reasons.size();
  const auto countOf = [&](Unmeasured reason, std::size_t first, std::size_t last) {
    std::size_t found = 0;
    for (std::size_t k = first; k <= last; ++k) found += reasons[k % count] == reason;
    return found;
  };
  const std::vector<RingRun> islands = islandsOf(reasons, far);
  std::size_t most = 0;
  for (const RingRun& run : islands) most = std::max(most, countOf(Unmeasured::None, run.first, run.last));
  std::vector<bool> outnumbered(count, false);
  for (const RingRun& run : islands) {
    const std::size_t stands = countOf(Unmeasured::None, run.first, run.last);
    const std::size_t length = run.last - run.first + 1, beside = std::min({length, far, (count - length) / 2});
    const std::size_t other = countOf(Unmeasured::OtherSurface, run.first + count - beside, run.last + count + beside);
    if (stands == most || other <= stands) continue;
    for (std::size_t k = run.first; k <= run.last; ++k) outnumbered[k % count] = reasons[k % count] == Unmeasured::None;
  }
  return outnumbered;
}

std::vector<bool> findLoneStations(const std::vector<Unmeasured>& reasons, std::size_t far) {
  constexpr double kFew = 2.0 * kDegree;  // over which an edge, as beams cross it, passes for a floor [rad]
  const std::size_t count = reasons.size();
  const auto few = static_cast<std::size_t>(std::lround(kFew / kTwoPi * static_cast<double>(count)));
  const std::vector<RingRun> islands = islandsOf(reasons, far);
  std::size_t longest = 0;
  for (const RingRun& run : islands) longest = std::max(longest, run.last - run.first + 1);
  std::vector<bool> lone(count, false);
  for (const RingRun& run : islands) {
    const std::size_t length = run.last - run.first + 1;
    if (length > few || length == longest) continue;
    for (std::size_t k = run.first; k <= run.last; ++k) lone[k % count] = true;
  }
  return lone;
}

double commonSigma(const std::vector<FootFit>& fits, std::size_t apart) {
  constexpr std::size_t kFewestDifferences = 20;
  // four in five of normal deviates are within 1.2816: more is heard of the tails than in a median, less than in a mean
  constexpr double kShare = 0.8, kWithin = 1.2816;
  std::vector<ThirdDifference> differences;  // at three lags, for their number
  for (std::size_t lag = apart; lag <= 3 * apart && 4 * lag < fits.size(); lag += apart)
    addDifferences(fits, lag, differences);
  if (differences.size() < kFewestDifferences) return 0.0;
  std::vector<double> ratios(differences.size());
  const auto excess = [&](double common) {
    std::transform(differences.begin(), differences.end(), ratios.begin(), [&](const ThirdDifference& d) {
      return std::abs(d.value) / std::sqrt(d.variance + kThirdDifference * common * common);
    });
    return quantile(ratios, kShare) / kWithin - 1.0;
  };
  double most = 0.0;
  for (const ThirdDifference& d : differences) most = std::max(most, std::abs(d.value));
  return leastWithout(excess, most, 40);
}

}  // namespace tank_datum
