#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_bends.h"
#include "foot/foot_patches.h"
#include "foot/foot_profile.h"
#include "foot/foot_rises.h"
#include "foot/foot_roughness.h"
#include "foot/foot_state.h"
#include "foot/station_stretches.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kWidestStretch = 5.0 * kPi / 180.0;
constexpr double kMostHelp = 20.0;  // stations that one may lean on, for the count of its points

/// Points on the surface in the two halves of a station's own stretch.
struct HalfCounts {
  std::size_t left = 0, right = 0;
  std::size_t both() const { return left + right; }
};

HalfCounts countHalves(const Foot& foot, const FootPass& pass, std::size_t station) {
  HalfCounts counts;
  if (!pass.fits[station].valid()) return counts;
  const FootProfile& profile = pass.sections.at(station);
  const double level = pass.fits[station].z;
  for (const FootPoint& p : foot.points[station]) {
    const bool in_band = p.d >= profile.band_from && p.d <= profile.band_to;
    if (in_band && fitsLevel(p, level, profile)) ++(p.t < 0.0 ? counts.left : counts.right);
  }
  return counts;
}

/// Points on the surface of each station's own stretch. Where many lie in one half only and the neighbour beyond the
/// other has none, something ends at the station: it has none either.
std::vector<std::size_t> pointsPerStation(const Foot& foot, const FootPass& pass) {
  constexpr std::size_t kMany = 8;
  const std::size_t count = pass.fits.size();
  std::vector<HalfCounts> halves(count);
  forEachIndex(count, 0, [&](std::size_t i) { halves[i] = countHalves(foot, pass, i); });
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < count; ++i) {
    const HalfCounts& own = halves[i];
    const std::size_t left = halves[(i + count - 1) % count].both(), right = halves[(i + 1) % count].both();
    const bool ends = own.both() >= kMany && ((own.left == 0 && left == 0) || (own.right == 0 && right == 0));
    counts.push_back(ends ? 0 : own.both());
  }
  return counts;
}

/// The points of the stations up to `reach` to either side of one.
std::size_t pointsWithin(const std::vector<std::size_t>& counts, std::size_t station, std::size_t reach) {
  std::size_t points = counts[station];
  for (std::size_t away = 1; away <= reach && 2 * away < counts.size(); ++away) {
    points += counts[(station + away) % counts.size()] + counts[(station + counts.size() - away) % counts.size()];
  }
  return points;
}

/// Which stations have a fit.
std::vector<bool> fittedOf(const FootPass& pass) {
  std::vector<bool> fitted;
  for (const FootFit& fit : pass.fits) fitted.push_back(fit.valid());
  return fitted;
}

/// The surface at the station that a stretch is fitted at, from the stretch's own points.
/// @param rough  variance that their heights share [m^2]
FittedPoints fitStretch(const Foot& foot, const FootPass& pass, const StationStretch& stretch, double rough) {
  const std::size_t at = stretch.at;
  const FootProfile& profile = pass.sections.at(at);
  const double beside = stretch.besideMiddle() * 2.0 * foot.half_step;
  const double half = static_cast<double>(stretch.count) * foot.half_step, z = pass.fits[at].z;
  std::vector<FootPoint> points = foot.ring.around(foot.directions[at] - beside, half, z, foot.reach);
  for (FootPoint& p : points) p.t -= beside * foot.radius;
  FootPrior prior = pass.priors.at(at);
  if (pass.priors.settled) prior.sigma_slope = kSettledSlope;
  prior.shared = rough;
  const FootFit fit = fitFoundation(points, profile, z + profile.offset, prior);
  return {std::move(points), pass.priors.blends.without(fit, at), pass.priors.steepnessAt(at)};
}

/// Of each station the stretch that it belongs to, where that could be fitted.
struct OwnFits {
  std::vector<FootFit> fits;
  std::vector<const FootFit*> of_station;
  std::vector<double> levels, sigmas;  ///< of the stations that stretches are fitted at, else NaN [m]
  LevelRoughness rough;

  /// Takes the fits of stations away, and of those whose stretch is fitted at one of them.
  void leaveOut(const std::vector<bool>& stations) {
    constexpr const FootFit* kNone = nullptr;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (!stations[i]) continue;
      const FootFit* fit = of_station[i];
      if (std::isfinite(levels[i])) std::replace(of_station.begin(), of_station.end(), fit, kNone);
      of_station[i] = nullptr;
      levels[i] = sigmas[i] = kUnknown;
    }
  }
};

/// Fits of stretches, and the roughness that they share. A wide surface is fitted again with it, as it draws slopes to
/// its patches.
std::vector<FittedPoints> fittedStretches(const Foot& foot, const FootPass& pass,
                                          const std::vector<StationStretch>& stretches, LevelRoughness& rough) {
  const FootProfile& section = pass.sections.whole;
  const Roughness patches = patchesOf(patchWindows(foot, pass), section);  // windows and stretches are not held at once
  std::vector<FittedPoints> fitted(stretches.size());
  const auto fitAll = [&](double shared) {
    forEachIndex(stretches.size(), 0, [&](std::size_t k) {
      if (pass.fits[stretches[k].at].valid()) fitted[k] = fitStretch(foot, pass, stretches[k], shared);
    });
  };
  fitAll(0.0);
  rough = levelRoughness(patches, section, foot.arc(), sharedRoughness(fitted, section));
  if (!pass.priors.settled) fitAll(rough.variance);
  return fitted;
}

OwnFits fitStretches(const Foot& foot, const FootPass& pass, const std::vector<std::size_t>& counts) {
  const std::size_t count = pass.fits.size();
  const std::vector<StationStretch> stretches = stretchesOf(counts, fittedOf(pass), foot.stationsIn(kWidestStretch));
  OwnFits own{std::vector<FootFit>(stretches.size()),
              std::vector<const FootFit*>(count, nullptr),
              std::vector<double>(count, kUnknown),
              std::vector<double>(count, kUnknown),
              {}};
  const std::vector<FittedPoints> fitted = fittedStretches(foot, pass, stretches, own.rough);
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    FootFit& fit = own.fits[k] = fitted[k].fit;
    if (!fit.valid()) continue;
    const double leverage = static_cast<double>(fit.points) * square(fit.sigma / fit.noise);
    if (pass.priors.settled) fit.sigma = std::sqrt(fit.sigma * fit.sigma + own.rough.variance * leverage);
    own.levels[stretches[k].at] = fit.z;
    own.sigmas[stretches[k].at] = fit.sigma;
    for (std::size_t i = 0; i < stretches[k].count; ++i) own.of_station[stretches[k].first + i] = &fit;
  }
  return own;
}

/// What blends do to the section's level, as the arcs show it; common to all stations [m].
double misfitOf(const FootSections& sections) {
  if (sections.arcs.empty()) return sections.whole.misfit;
  std::vector<double> misfits;
  for (const FootProfile& arc : sections.arcs) misfits.push_back(arc.misfit);
  return median(misfits);
}

/// The process with what all of its stations share in its sigmas, and what neighbours do of a rough surface.
RingProcess withShared(RingProcess process, const OwnFits& own, const std::vector<double>& shared) {
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const FootFit* fit = own.of_station[i];
    const double patches = fit == nullptr ? 0.0 : own.rough.leftOutBy(process, i, fit->sigma);
    process.sigma[i] = std::sqrt(square(process.sigma[i]) + square(shared[i]) + patches);
  }
  return process;
}

/// Of each station the standard error that no count of points lessens: by the slope that is settled, or what is known
/// of it before, by blends, and by rounding. Slopes that differ from window to window by more than patches explain do
/// so from station to station too.
std::vector<double> sharedSigmas(const Foot& foot, const FootPass& pass, const LevelRoughness& rough) {
  const double misfit = misfitOf(pass.sections);
  const double uneven = rough.slopesBeyond(pass.priors.uneven, pass.sections.whole, kSlopeWindow * foot.radius);
  std::vector<double> shared;
  for (std::size_t i = 0; i < pass.fits.size(); ++i) {
    const FootFit& fit = pass.fits[i];
    const double known = pass.priors.sigma_slope[i], told = square(fit.sigma_slope / known);
    const double alike =
        pass.priors.settled ? std::hypot(known, uneven) : std::hypot(pass.priors.feigned * told, pass.priors.lifted);
    const double slope = fit.valid() ? fit.middle * alike : 0.0;
    shared.push_back(std::hypot(std::hypot(slope, fit.lifted.z), std::hypot(misfit, fit.rounding)));
  }
  return shared;
}

/// Levels without those of steep dips: a process that follows them follows the roughness of the rest as well.
std::vector<double> withoutDips(std::vector<double> levels, const FootPass& pass) {
  const std::vector<bool>& dips = pass.outliers.dips;
  for (std::size_t i = 0; i < dips.size(); ++i) {
    if (dips[i]) levels[i] = kUnknown;
  }
  return levels;
}

/// The same where too few stretches stand alone to say what the ring does: stations that rise towards soil are told by
/// windows, which have points in common.
FootLevels withoutRises(const Foot& foot, const FootPass& pass, FootLevels levels) {
  std::vector<double> known, sigmas;
  for (std::size_t i = 0; i < pass.fits.size(); ++i) {
    const FootFit& fit = pass.fits[i];
    const double stations = std::max(1.0, fit.half_width / foot.half_step);
    known.push_back(pass.outliers.reasons[i] == Unmeasured::None ? fit.z : kUnknown);
    sigmas.push_back(fit.sigma * std::sqrt(stations));
  }
  const std::vector<bool> rises = findRises(foot, pass.outliers, withoutDips(known, pass), sigmas);
  for (std::size_t i = 0; i < rises.size(); ++i) {
    if (rises[i]) levels.fits[i] = {};
  }
  return levels;
}

}  // namespace

FootLevels levelStations(const Foot& foot, const FootPass& pass) {
  const std::vector<std::size_t> counts = pointsPerStation(foot, pass);
  OwnFits own = fitStretches(foot, pass, counts);
  own.leaveOut(findRises(foot, pass.outliers, withoutDips(own.levels, pass), own.sigmas));
  FootLevels levels{pass.fits, followRing(withoutDips(own.levels, pass), own.sigmas, kDip * foot.reach)};
  if (!levels.process.valid()) return withoutRises(foot, pass, std::move(levels));
  const std::vector<Bend> bends = findBends(foot, own.levels, own.sigmas, levels.process);
  const std::vector<double> shared = sharedSigmas(foot, pass, own.rough);
  levels.process = withShared(withRisesDoubted(std::move(levels.process)), own, shared);
  const RingProcess& process = levels.process;
  for (std::size_t i = 0; i < levels.fits.size(); ++i) {
    FootFit& fit = levels.fits[i];
    if (own.of_station[i] == nullptr) fit = {};
    if (!fit.valid()) continue;
    const double alone = std::hypot(std::hypot(own.sigmas[i], process.nugget), shared[i]);
    fit.half_width = foot.half_step;
    fit.points = counts[i];
    if (alone < foot.options.wanted_sigma) {
      fit.z = own.levels[i];
      fit.sigma = alone;
      continue;
    }
    const FootFit window = pass.priors.blends.without(pass.fits[i], i);
    if (bends[i] != Bend::None) {
      const double alike = std::sqrt(square(shared[i]) + own.rough.over(2.0 * window.half_width * foot.radius));
      fit = bentFit(window, process, i, alike, bends[i]);
      continue;
    }
    const double gain = own.of_station[i]->sigma / process.sigma[i];
    fit.z = process.value[i];
    fit.sigma = std::hypot(process.sigma[i], disagreement(window, process, i));
    fit.half_width *= std::clamp(gain * gain, 1.0, kMostHelp);
    fit.points = pointsWithin(counts, i, static_cast<std::size_t>(std::lround(0.5 * fit.half_width / foot.half_step)));
  }
  return levels;
}

}  // namespace tank_datum
