#include "foot/foot_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

using Places = std::vector<std::vector<FootCandidate>>;
using Choice = std::vector<std::optional<std::size_t>>;
using Costs = std::vector<std::vector<double>>;  // of each place's candidates, and of none

constexpr double kNone = 2.5;      // cost of choosing nothing at a place, in which the others are counted
constexpr double kEnterGap = 0.5;  // of going from something to nothing or back

/// What the better places of the ring show: how near to the shell a stretch begins, and its noise [m].
struct Usual {
  double from, noise;
};

constexpr double kLeast = 0.03;  // of the reach that two at one level differ by: sections tell lip, ringwall and crown

/// What speaks against a stretch, 0 for none.
double costOf(const FootCandidate& c, const Usual& usual, double reach) {
  constexpr double kGap = 0.05;          // of the reach: a stretch that begins so much further out than usual
  constexpr double kUsualSlope = 0.05;   // [m/m]
  constexpr double kShellBelow = 0.004;  // of the reach: the shell is seen that far below, so the stretch ends before
  constexpr double kHidden = 0.2;        // of the reach: a shell seen no further down is hidden by something
  double cost = std::max(0.0, c.from - usual.from) / (kGap * reach);
  const double steep = std::max(0.0, std::abs(c.slope) - 2.0 * c.sigma_slope) / kUsualSlope;
  cost += 0.5 * steep * steep;
  cost += std::max(0.0, portable::log2(c.noise / usual.noise) - 1.0);
  if (c.over_foot > kShellBelow * reach + 3.0 * std::max(c.error, c.noise)) cost += 2.0 * kNone;
  if (c.over_foot < -kHidden * reach) cost += 1.0;
  return cost;
}

std::size_t cheapestOf(const std::vector<double>& costs) {
  return static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
}

/// How far two stretches at one level may differ in height, usually: a datum climbs, and they are known so well.
double usualDifference(const FootCandidate& a, const FootCandidate& b, double arc, double reach) {
  constexpr double kClimb = 0.004;  // of a datum along its shell over a short arc [m/m]
  constexpr double kShort = 4.0;    // reaches
  constexpr double kFar = 0.001;    // and over a long one [m/m]
  return kClimb * std::min(arc, kShort * reach) + kFar * arc + kLeast * reach + std::hypot(a.error, b.error);
}

/// The places, with heights over the tilt of what most of them show: a shell may stand upright on a floor that falls to
/// one side, and climbs along it by more than a level datum.
/// @param costs  of every place's candidates
Places overTilt(Places places, const Costs& costs, double arc, double reach) {
  constexpr double kMostFall = 0.02;  // of a floor; terrain may fall more [m/m]
  constexpr double kShortArc = 1e-4;  // so that a few places have a tilt
  std::vector<double> azimuths, heights;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t best = cheapestOf(costs[i]);
    if (best == places[i].size()) continue;
    azimuths.push_back(middleOfCell(i, places.size()));
    heights.push_back(places[i][best].height);
  }
  if (heights.empty()) return places;
  const PeriodicFit tilt = fitHarmonics(azimuths, heights, {}, {1, true, kShortArc});
  const double radius = arc * static_cast<double>(places.size()) / kTwoPi;
  const double fall = std::hypot(tilt.coefficients[1], tilt.coefficients[2]) / radius;
  if (!(tilt.sigma < kLeast * reach && fall <= kMostFall)) return places;  // most are on no tilted floor
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (FootCandidate& c : places[i]) c.height -= tilt(middleOfCell(i, places.size()));
  }
  return places;
}

/// The places as states of a path: state s of place i is candidate s, the last state is none of them.
struct RingPath {
  const Places& places;
  const Costs& costs;
  double arc, reach;

  double stepCost(std::size_t i, std::size_t s, std::size_t j, std::size_t t) const {
    const bool none_i = s == places[i].size(), none_j = t == places[j].size();
    if (none_i || none_j) return none_i == none_j ? 0.0 : kEnterGap;
    const FootCandidate &a = places[i][s], &b = places[j][t];
    const double off = (a.height - b.height) / usualDifference(a, b, arc, reach);
    return off * off;  // at most what a place of none between them costs
  }
};

/// The cheapest path that begins and ends in the best state of the clearest place.
Choice cheapestPath(const RingPath& ring) {
  const std::size_t count = ring.places.size();
  std::size_t start = 0;
  const auto least = [&](std::size_t i) { return ring.costs[i][cheapestOf(ring.costs[i])]; };
  for (std::size_t i = 1; i < count; ++i) {
    if (least(i) < least(start)) start = i;
  }
  std::vector<std::vector<std::size_t>> from(count);
  const std::vector<double>& first = ring.costs[start];
  const std::size_t begin = cheapestOf(first);
  std::vector<double> before(first.size(), std::numeric_limits<double>::infinity());
  before[begin] = 0.0;
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t i = (start + k - 1) % count, j = (start + k) % count;
    std::vector<double> now(ring.costs[j].size(), std::numeric_limits<double>::infinity());
    from[j].assign(now.size(), 0);
    for (std::size_t t = 0; t < now.size(); ++t) {
      for (std::size_t s = 0; s < before.size(); ++s) {
        const double cost = before[s] + ring.stepCost(i, s, j, t) + ring.costs[j][t];
        if (cost < now[t]) now[t] = cost, from[j][t] = s;
      }
    }
    before = std::move(now);
  }
  Choice choice(count);
  std::size_t state = begin;
  for (std::size_t k = count; k > 0; --k) {
    const std::size_t j = (start + k) % count;
    if (state < ring.places[j].size()) choice[j] = state;
    state = from[j][state];
  }
  return choice;
}

/// Neighbouring choices at one level.
struct Run {
  std::vector<std::size_t> members;
  double cost = 0;  ///< mean of its members', less what its length is worth
};

std::vector<Run> runsOf(const RingPath& ring, const Choice& choice) {
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < choice.size(); ++i) {
    if (choice[i]) seen.push_back(i);
  }
  const auto beginsAt = [&](std::size_t k) {
    const std::size_t at = seen[k], before = seen[(k + seen.size() - 1) % seen.size()];
    const auto apart = static_cast<double>((at + choice.size() - before) % choice.size());
    const FootCandidate &a = ring.places[before][*choice[before]], &b = ring.places[at][*choice[at]];
    return std::abs(a.height - b.height) > 2.0 * usualDifference(a, b, apart * ring.arc, ring.reach);
  };
  std::vector<Run> runs;
  for (const RingRun& between : runsBetween(seen.size(), beginsAt)) {
    Run run;
    for (std::size_t k = between.first; k <= between.last; ++k) {
      const std::size_t at = seen[k % seen.size()];
      run.members.push_back(at);
      run.cost += ring.costs[at][*choice[at]];
    }
    const auto length = static_cast<double>(run.members.size());
    run.cost = run.cost / length - 0.25 * portable::log2(length);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

std::vector<std::optional<std::size_t>> chooseRoundRing(const Places& places, double arc, double reach,
                                                        std::vector<bool>* between) {
  std::vector<double> noises, beginnings;
  for (const auto& place : places) {
    for (const FootCandidate& c : place) noises.push_back(c.noise);
    if (!place.empty()) beginnings.push_back(place.front().from);
  }
  if (noises.empty()) return Choice(places.size());
  const Usual usual{quantile(beginnings, 0.25), std::max(quantile(noises, 0.1), 1e-7)};
  Costs costs;
  for (const auto& place : places) {
    costs.emplace_back();
    for (const FootCandidate& c : place) costs.back().push_back(costOf(c, usual, reach));
    costs.back().push_back(kNone);
  }
  const Places level = overTilt(places, costs, arc, reach);
  const RingPath ring{level, costs, arc, reach};
  Choice choice = cheapestPath(ring);
  auto runs = runsOf(ring, choice);
  if (between != nullptr && !runs.empty()) {
    for (const auto& chosen : choice) between->push_back(!chosen);
  }
  for (; !runs.empty(); runs = runsOf(ring, choice)) {
    const auto dearest =
        std::max_element(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.cost < b.cost; });
    for (const std::size_t i : dearest->members) choice[i].reset();
  }
  return choice;
}

}  // namespace tank_datum
