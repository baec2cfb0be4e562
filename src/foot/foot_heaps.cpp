#include "foot/foot_heaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/line_sums.h"
#include "foot/ring_slope.h"

namespace tank_datum {
namespace {

/// What stations and their neighbours show all together, and its standard error; NaN of none.
struct Together {
  double value, sigma;

  /// @param own  with weights one over their variances
  explicit Together(std::vector<WeightedValue> own) {
    double weights = 0.0;
    for (const WeightedValue& v : own) weights += v.weight;
    sigma = kMedianOverMean * std::sqrt(kWithNeighbours / weights);
    value = weightedMedian(std::move(own));
  }
};

/// How far the slopes of points in a run lie off what a wide surface does elsewhere, all together, beyond what they err
/// by [m/m].
/// @param own  of stations and their neighbours, where they stand
double strangeSlope(const RingRun& run, const std::vector<FootFit>& own, const FootPriors& priors) {
  std::vector<WeightedValue> offs;
  for (std::size_t k = run.first; k <= run.last; ++k) {
    const std::size_t i = k % own.size();
    if (!own[i].valid()) continue;
    const double weight = 1.0 / (square(own[i].sigma_slope) + square(priors.sigma_slope[i]));
    offs.push_back({own[i].slope - priors.slope[i], weight});
  }
  if (offs.empty()) return 0.0;
  const Together off(std::move(offs));
  return std::abs(off.value) - 3.0 * off.sigma;
}

}  // namespace

FootFit ownFit(const Foot& foot, std::size_t station, const FootPass& pass, double half_width) {
  const FootFit& fit = pass.fits[station];
  const FootProfile& profile = pass.sections.at(station);
  FootPrior any = pass.priors.at(station);
  any.sigma_slope = 1.0;
  const auto points = foot.ring.around(foot.directions[station], half_width, fit.z, foot.reach);
  return fitFoundation(points, profile, fit.z + profile.offset, any);
}

bool isHeap(std::size_t station, const FootPriors& priors, const FootFit& own) {
  const double usual = priors.slope[station];
  if (!own.valid()) return false;
  if (priors.settled) return own.slope < std::min(usual, priors.seen) - kSteepestLip - 3.0 * own.sigma_slope;
  return own.slope < usual - kHeapFalls - 3.0 * std::hypot(own.sigma_slope, priors.sigma_slope[station]);
}

bool isHeapInHalf(const Foot& foot, std::size_t station, const FootPass& pass) {
  return isHeap(station, pass.priors, ownFit(foot, station, pass, 0.5 * pass.fits[station].half_width));
}

bool isHeapBefore(const Foot& foot, std::size_t station, const FootPass& pass) {
  constexpr double kFrom = 0.1;    // of the reach: welds are smaller
  constexpr double kHigh = 0.3;    // of the reach: what hangs over the foot lies higher
  constexpr double kFalls = 0.15;  // [m/m]
  constexpr double kLine = 0.8;    // of the heights' squares
  const FootFit& fit = pass.fits[station];
  const double within = heightTolerance(pass.sections.at(station));
  LineSums line;
  double above = 0.0;
  for (const FootPoint& p : foot.points[station]) {
    const double height = p.z - fit.z - fit.slope * p.d;
    if (p.d < kFrom * foot.reach || p.d > fit.middle || height < -within || height > kHigh * foot.reach) continue;
    line.add(p.d, height);
    above += height > within ? 1.0 : 0.0;
  }
  return 2.0 * above > line.n && line.slope() < -kFalls && line.explained() > kLine;
}

bool areHeaps(const std::vector<FootFit>& own, const FootPriors& priors) {
  std::vector<WeightedValue> slopes;
  for (const FootFit& fit : own) {
    if (fit.valid()) slopes.push_back({fit.slope, 1.0 / (fit.sigma_slope * fit.sigma_slope)});
  }
  if (!priors.settled || slopes.empty()) return false;
  const Together slope(std::move(slopes));
  return slope.value < std::min(0.0, priors.seen) - kSteepestLip - 3.0 * slope.sigma;
}

std::vector<bool> findHeapedArcs(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own) {
  constexpr double kArc = 5.0 * kDegree;  // to either side, that is looked at together
  constexpr double kSteeper = 0.02;       // a lip's slope varies by less along the shell [m/m]
  const std::size_t count = own.size(), near = foot.stationsBeside(kArc);
  std::vector<bool> heaped(count, false);
  if (!priors.settled) return heaped;
  for (std::size_t i = 0; i < count; ++i) {
    if (!own[i].valid()) continue;
    std::vector<WeightedValue> offs;
    for (std::size_t k = i + count - near; k <= i + count + near; ++k) {
      const FootFit& fit = own[k % count];
      if (!fit.valid()) continue;
      const double feigned = priors.blends.slope.empty() ? 0.0 : priors.blends.slope[k % count];
      const double usual = std::min(priors.slope[k % count], priors.seen) + feigned;
      offs.push_back({fit.slope - usual, 1.0 / square(fit.sigma_slope)});
    }
    const Together off(std::move(offs));
    heaped[i] = off.value < -kSteeper - 3.0 * off.sigma;
  }
  return heaped;
}

std::vector<bool> findHeapsGoingOn(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own,
                                   const std::vector<bool>& heaps) {
  constexpr double kScatter = 0.5;         // of what the surface does elsewhere
  constexpr double kFar = 20.0 * kDegree;  // over which a heap may go on unseen
  constexpr std::size_t kPart = 6;         // of the ring: longer ones are no heaps
  const std::size_t count = own.size(), far = foot.stationsIn(kFar);
  std::vector<bool> going_on(count, false);
  if (priors.settled) return going_on;
  const auto tells = [&](const FootFit& fit) {
    return fit.sigma_slope < kSlopeVaries && fit.own > kScatter * priors.scatter;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!heaps[i]) continue;
    for (const bool ahead : {false, true}) {
      for (std::size_t away = 1, last = 0; away <= std::min(last + far, count / kPart); ++away) {
        const std::size_t k = (ahead ? i + away : i + count - away) % count;
        if (!own[k].valid()) continue;
        if (tells(own[k])) break;
        going_on[k] = true, last = away;
      }
    }
  }
  return going_on;
}

std::vector<bool> findStrangeIslands(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own) {
  const std::size_t count = own.size(), far = foot.stationsIn(kFarIsland);
  std::vector<bool> islands(count, false);
  if (priors.settled) return islands;
  std::vector<char> stand;
  for (const FootFit& fit : own) stand.push_back(fit.valid() ? 1 : 0);
  for (const RingRun& run : runsRound(stand, far)) {
    const bool few = run.last - run.first < far;
    if (!few || !(strangeSlope(run, own, priors) > kSlopeVaries)) continue;
    for (std::size_t k = run.first; k <= run.last; ++k) islands[k % count] = true;
  }
  return islands;
}

}  // namespace tank_datum
