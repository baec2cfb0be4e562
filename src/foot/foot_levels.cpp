#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/foot_state.h"
#include "tank_datum/core/parallel.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kDip = 0.01;       // of the reach: what a datum may do locally, on a ring that is quiet elsewhere
constexpr double kMostHelp = 20.0;  // stations that one may lean on, for the count of its points
constexpr double kSettled = 1e-4;   // slope that is not to be learnt again [m/m]

/// A stretch of neighbouring stations that are fitted together.
struct Stretch {
  std::size_t first, count;
  std::size_t middle() const { return first + count / 2; }
};

std::vector<std::size_t> pointsPerStation(const Foot& foot, const FootSections& sections) {
  constexpr std::size_t kMany = 8;
  std::vector<std::size_t> counts(foot.fits.size(), 0);
  forEachIndex(counts.size(), 0, [&](std::size_t i) {
    if (!foot.fits[i].valid()) return;
    const FootProfile& profile = sections.at(i);
    const double level = foot.fits[i].z, within = 8.0 * profile.noise + profile.blur;
    std::size_t left = 0, right = 0;
    for (const FootPoint& p : foot.points[i]) {
      const bool in_band = p.d >= profile.band_from && p.d <= profile.band_to;
      if (in_band && std::abs(p.z - level - profile.slope * p.d) < within) ++(p.t < 0.0 ? left : right);
    }
    // many on one side of the station only: something ends at it
    counts[i] = left + right < kMany || (left > 0 && right > 0) ? left + right : 0;
  });
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

/// Stretches of one station where it has points enough, else of a few neighbours; none that begins or ends without
/// points.
std::vector<Stretch> stretchesOf(const Foot& foot, const std::vector<std::size_t>& counts) {
  constexpr std::size_t kEnough = 8;
  constexpr double kWidest = 5.0 * kPi / 180.0;
  const double widest = std::min(kWidest, 2.0 * foot.options.widest_window / foot.radius);
  const auto longest = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * widest / foot.half_step)));
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < counts.size();) {
    if (counts[i] == 0) {
      ++i;
      continue;
    }
    std::size_t points = 0, length = 0;
    for (std::size_t k = 0; k < longest && i + k < counts.size() && points < kEnough; ++k) {
      points += counts[i + k];
      if (counts[i + k] > 0) length = k + 1;
    }
    stretches.push_back({i, length});
    i += length;
  }
  return stretches;
}

/// The surface at a stretch's middle station, from the stretch's own points.
FootFit fitStretch(const Foot& foot, const FootSections& sections, const FootPriors& priors, const Stretch& stretch) {
  const std::size_t at = stretch.middle();
  const FootProfile& profile = sections.at(at);
  // of an even number of stations the middle one stands half a step beside the middle
  const double step = std::remainder(foot.directions[1] - foot.directions[0], kTwoPi);
  const double beside = stretch.count % 2 == 0 ? 0.5 * step : 0.0;
  const double half = static_cast<double>(stretch.count) * foot.half_step, z = foot.fits[at].z;
  std::vector<FootPoint> points = foot.ring.around(foot.directions[at] - beside, half, z, foot.reach);
  for (FootPoint& p : points) p.t -= beside * foot.radius;
  FootPrior prior = priors.at(at);
  if (priors.settled) prior.sigma_slope = kSettled;
  return fitFoot(points, profile, z + profile.offset, priors.slope[at], prior);
}

/// Of each station the stretch that it belongs to, where that could be fitted.
struct OwnFits {
  std::vector<FootFit> fits;
  std::vector<const FootFit*> of_station;
  std::vector<double> levels, sigmas;  ///< of middle stations, else NaN [m]
};

OwnFits fitStretches(const Foot& foot, const FootSections& sections, const FootPriors& priors,
                     const std::vector<std::size_t>& counts) {
  const std::size_t count = foot.fits.size();
  const std::vector<Stretch> stretches = stretchesOf(foot, counts);
  OwnFits own{std::vector<FootFit>(stretches.size()), std::vector<const FootFit*>(count, nullptr),
              std::vector<double>(count, kUnknown), std::vector<double>(count, kUnknown)};
  forEachIndex(stretches.size(), 0, [&](std::size_t k) {
    if (foot.fits[stretches[k].middle()].valid()) own.fits[k] = fitStretch(foot, sections, priors, stretches[k]);
  });
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    if (!own.fits[k].valid()) continue;
    own.levels[stretches[k].middle()] = own.fits[k].z;
    own.sigmas[stretches[k].middle()] = own.fits[k].sigma;
    for (std::size_t i = 0; i < stretches[k].count; ++i) own.of_station[stretches[k].first + i] = &own.fits[k];
  }
  return own;
}

}  // namespace

RingProcess levelStations(Foot& foot, const FootSections& sections, const FootPriors& priors, double misfit) {
  const std::vector<std::size_t> counts = pointsPerStation(foot, sections);
  const OwnFits own = fitStretches(foot, sections, priors, counts);
  RingProcess process = followRing(own.levels, own.sigmas, kDip * foot.reach);
  if (!process.valid()) return process;
  for (std::size_t i = 0; i < foot.fits.size(); ++i) {
    FootFit& fit = foot.fits[i];
    const double shared = priors.settled && fit.valid() ? fit.middle * priors.sigma_slope[i] : 0.0;
    process.sigma[i] = std::hypot(process.sigma[i], std::hypot(shared, misfit));
    if (!fit.valid()) continue;
    if (own.of_station[i] == nullptr) {
      fit = {};
      continue;
    }
    const double alone = std::hypot(std::hypot(own.sigmas[i], process.nugget), std::hypot(shared, misfit));
    fit.half_width = foot.half_step;
    fit.points = counts[i];
    if (alone < foot.options.wanted_sigma) {
      fit.z = own.levels[i];
      fit.sigma = alone;
      continue;
    }
    const double gain = own.of_station[i]->sigma / process.sigma[i];
    fit.z = process.value[i];
    fit.sigma = process.sigma[i];
    fit.half_width *= std::clamp(gain * gain, 1.0, kMostHelp);
    fit.points = pointsWithin(counts, i, static_cast<std::size_t>(std::lround(0.5 * fit.half_width / foot.half_step)));
  }
  return process;
}

}  // namespace tank_datum
