#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_banks.h"
#include "foot/foot_check.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "foot/foot_state.h"
#include "foot/ring_slope.h"
#include "foot/shell_below.h"
#include "foot/slanting_beams.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// How many points of the surface that was fitted at a station its own stretch has, and whether it lies between points
/// of it.
struct Support {
  std::size_t own = 0;
  bool between = false;
};

Support supportOf(const Foot& foot, std::size_t station, const FootPass& pass) {
  const double step = foot.arc(), azimuth = foot.directions[station];
  const FootFit& fit = pass.fits[station];
  const FootProfile& profile = pass.sections.at(station);
  Support support;
  if (!fit.valid()) return support;
  const double within = 4.0 * fit.noise;
  bool left = false, right = false;
  foot.ring.visitAround(azimuth, 2.0 * foot.half_step, fit.z, foot.reach, [&](const FootPoint& p) {
    if (p.d < profile.band_from || p.d > profile.band_to) return;
    if (std::abs(offOf(p, fit)) > within) return;
    support.own += std::abs(p.t) <= 0.5 * step;
    (p.t < 0.0 ? left : right) = true;
  });
  support.between = left && right;
  return support;
}

/// A station is supported by points of its own; where the scan is so coarse that a stretch may be empty by chance, also
/// by points within a step on either side.
std::vector<bool> findSupport(const Foot& foot, const FootPass& pass) {
  constexpr double kPlenty = 20.0;
  std::vector<Support> supports(foot.directions.size());
  forEachIndex(supports.size(), 0, [&](std::size_t i) { supports[i] = supportOf(foot, i, pass); });
  std::vector<double> counts;
  for (const Support& s : supports) {
    if (s.own > 0) counts.push_back(static_cast<double>(s.own));
  }
  const bool coarse = median(counts) < kPlenty;
  std::vector<bool> supported;
  for (const Support& s : supports) supported.push_back(s.own > 0 || (coarse && s.between));
  return supported;
}

/// Whether a surface falls outwards or rises as no foundation does at its shell, here or all round: a bank.
bool isSteep(const FootFit& fit, const FootPriors& priors) {
  constexpr double kSteepest = 0.15;  // shoulders fall more steeply, but not at the shell [m/m]
  return std::abs(fit.slope) > kSteepest + 3.0 * fit.sigma_slope || std::abs(priors.seen) > kSteepest;
}

/// isGrazed() of what a station's window shows.
bool isGrazedAt(const Foot& foot, std::size_t station, const FootPass& pass) {
  const FootFit& fit = pass.fits[station];
  if (!risesOutwards(fit)) return false;  // which spares gathering the points
  const auto points = foot.ring.around(foot.directions[station], fit.half_width, fit.z, foot.reach);
  return isGrazed(points, pass.sections.at(station), fit, foot.reach);
}

/// The surface at a station as its points lie, whatever its slope is known to be.
/// @param half_width  of the window that is looked at [rad]
FootFit ownFit(const Foot& foot, std::size_t station, const FootPass& pass, double half_width) {
  const FootFit& fit = pass.fits[station];
  const FootProfile& profile = pass.sections.at(station);
  FootPrior any = pass.priors.at(station);
  any.sigma_slope = 1.0;
  const auto points = foot.ring.around(foot.directions[station], half_width, fit.z, foot.reach);
  return fitFoundation(points, profile, fit.z + profile.offset, pass.priors.slope[station], any);
}

/// Whether points rise to the shell as no foundation does, which a fit that is told the slope does not show: a heap of
/// soil. (They fall to it where few rows of the scan cross the lip: range noise moves a row's points along their rays.)
bool isHeap(std::size_t station, const FootPriors& priors, const FootFit& own) {
  const double usual = priors.slope[station];
  if (!own.valid()) return false;
  if (priors.settled) return own.slope < std::min(usual, priors.seen) - kSteepestLip - 3.0 * own.sigma_slope;
  return own.slope < usual - kHeapFalls - 3.0 * std::hypot(own.sigma_slope, priors.sigma_slope[station]);
}

/// The same of half the window that a station is fitted in.
bool isHeapInHalf(const Foot& foot, std::size_t station, const FootPass& pass) {
  return isHeap(station, pass.priors, ownFit(foot, station, pass, 0.5 * pass.fits[station].half_width));
}

/// What stations and their neighbours show all together, and its standard error; NaN of none.
struct Together {
  double value, sigma;

  /// @param own  with weights one over their variances
  explicit Together(std::vector<WeightedValue> own) {
    constexpr double kShared = 3.0;  // stations that a point counts for
    double weights = 0.0;
    for (const WeightedValue& v : own) weights += v.weight;
    sigma = kMedianOverMean * std::sqrt(kShared / weights);
    value = weightedMedian(std::move(own));
  }
};

/// Whether the points of stations that stand rise to the shell as those of no lip do, all together: on sparse feet none
/// of them tells by itself.
/// @param own  of stations and their neighbours, where they stand
bool areHeaps(const std::vector<FootFit>& own, const FootPriors& priors) {
  std::vector<WeightedValue> slopes;
  for (const FootFit& fit : own) {
    if (fit.valid()) slopes.push_back({fit.slope, 1.0 / (fit.sigma_slope * fit.sigma_slope)});
  }
  if (!priors.settled || slopes.empty()) return false;
  const Together slope(std::move(slopes));
  return slope.value < std::min(0.0, priors.seen) - kSteepestLip - 3.0 * slope.sigma;
}

/// The fits without those of stations that do not stand.
std::vector<FootFit> standing(std::vector<FootFit> fits, const std::vector<Unmeasured>& reasons) {
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (reasons[i] != Unmeasured::None) fits[i] = {};
  }
  return fits;
}

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

/// A few stations far from all others, which cannot be told by their elevation: whether they lie on soil, by a slope
/// that the foundation does not have.
std::vector<bool> findStrangeIslands(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own) {
  constexpr double kSlope = 0.03;          // a foundation's varies by less along the shell [m/m]
  constexpr double kFar = 10.0 * kDegree;  // over which no gap is bridged
  const std::size_t count = own.size(), far = foot.stationsIn(kFar);
  std::vector<bool> islands(count, false);
  if (priors.settled) return islands;
  std::vector<char> stand;
  for (const FootFit& fit : own) stand.push_back(fit.valid() ? 1 : 0);
  for (const RingRun& run : runsRound(stand, far)) {
    const bool few = run.last - run.first < far;
    if (!few || !(strangeSlope(run, own, priors) > kSlope)) continue;
    for (std::size_t k = run.first; k <= run.last; ++k) islands[k % count] = true;
  }
  return islands;
}

/// Whether the shell is seen, at the stations of a run, to go down to them from the level beside.
bool goesDownTo(const Foot& foot, const StepRun& run, const std::vector<FootFit>& fits) {
  ShellCounts shell;
  for (const std::size_t i : run.stations)
    shell.add(countShell(foot, i, levelAt(foot, run.beside, 0.0), run.beside - fits[i].z));
  return shell.goOn();
}

}  // namespace

FootOutliers findOutliers(const Foot& foot, const FootPass& pass) {
  const std::vector<bool> supported = findSupport(foot, pass);
  std::vector<Unmeasured> reasons(pass.fits.size(), Unmeasured::None);
  std::vector<char> before(reasons.size(), 0), no_foot(reasons.size(), 0);
  std::vector<FootFit> own(reasons.size());
  forEachIndex(reasons.size(), 0, [&](std::size_t i) {
    const FootFit& fit = pass.fits[i];
    if (!foot.shell_seen[i]) {
      reasons[i] = Unmeasured::NoShell;
    } else if (!fit.valid() || !supported[i]) {
      reasons[i] = Unmeasured::Hidden;
    } else {
      before[i] = countShell(foot, i, fit).goOn() ? 1 : 0;
      own[i] = ownFit(foot, i, pass, 3.0 * foot.half_step);
      no_foot[i] = before[i] || isSteep(fit, pass.priors) || isGrazedAt(foot, i, pass) ||
                           isHeap(i, pass.priors, own[i]) || isHeapInHalf(foot, i, pass)
                       ? 1
                       : 0;
      const bool other = no_foot[i] || !isSameSurface(foot.points[i], fit, pass.priors.slope[i], pass.sections.at(i));
      if (other) reasons[i] = Unmeasured::OtherSurface;
    }
  });
  const std::vector<bool> shell_below = findShellBelow(foot, standing(pass.fits, reasons));
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!shell_below[i]) continue;
    before[i] = no_foot[i] = 1;
    reasons[i] = Unmeasured::OtherSurface;
  }
  own = standing(std::move(own), reasons);
  const auto stand = std::count(reasons.begin(), reasons.end(), Unmeasured::None);
  const auto kerbs = std::count(before.begin(), before.end(), 1);
  const bool none =
      static_cast<std::size_t>(stand) < kAsMany * static_cast<std::size_t>(kerbs) || areHeaps(own, pass.priors);
  const std::vector<FootFit> kept = standing(pass.fits, reasons);
  const std::vector<double> levels = elevationsOf(kept);
  const std::vector<bool> banks = findBanks(foot, pass.sections.whole, levels);
  const std::vector<bool> hanging = findHangingRuns(foot, levels), islands = findStrangeIslands(foot, pass.priors, own);
  Steps steps = findSteps(kept, foot.arc(), [&](const StepRun& run) { return goesDownTo(foot, run, kept); });
  std::vector<double> refused(reasons.size(), kUnknown);
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (reasons[i] == Unmeasured::None && (none || steps.dropped[i] || banks[i] || hanging[i] || islands[i]))
      reasons[i] = Unmeasured::OtherSurface;
    const bool may_be = !none && no_foot[i] == 0 && !hanging[i] && !islands[i];
    if (reasons[i] == Unmeasured::OtherSurface && may_be) refused[i] = pass.fits[i].z;
  }
  return {std::move(reasons), std::move(steps.dips), std::move(refused)};
}

std::vector<double> elevationsOf(const std::vector<FootFit>& fits) {
  std::vector<double> elevations;
  for (const FootFit& fit : fits) elevations.push_back(fit.z);
  return elevations;
}

std::vector<double> withoutOutliers(const std::vector<double>& elevations, const FootOutliers& outliers) {
  std::vector<double> kept = elevations;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (outliers.reasons[i] != Unmeasured::None) kept[i] = kUnknown;
  }
  const auto known = [](double z) { return std::isfinite(z); };
  return 2 * std::count_if(kept.begin(), kept.end(), known) > std::count_if(elevations.begin(), elevations.end(), known)
             ? kept
             : elevations;
}

}  // namespace tank_datum
