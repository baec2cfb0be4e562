#include "foot/slope_windows.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/statistics.h"
#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

Slopes fitSlopes(const Foot& foot, const FootElevations& elevations, const FootSections& sections,
                 const SlopeWindows& windows, double sigma_bend) {
  const std::size_t count = foot.directions.size();
  Slopes slopes;
  slopes.stride = std::max<std::size_t>(1, count / windows.count);
  slopes.fits.resize((count + slopes.stride - 1) / slopes.stride);
  slopes.bands.resize(slopes.fits.size());
  std::vector<RayCounts> rays(slopes.fits.size());
  FootPrior any;
  any.sigma_slope = windows.sigma_slope;
  any.sigma_bend = sigma_bend;
  any.scatter = windows.scatter;
  any.rounding.step = foot.rounding;
  forEachIndex(slopes.fits.size(), 0, [&](std::size_t k) {
    const std::size_t i = k * slopes.stride;
    if (!elevations.seen[i]) return;
    const FootProfile& profile = sections.at(i);
    const double level = elevations.filled[i];
    const auto points = foot.ring.around(foot.directions[i], windows.half, level, foot.reach);
    FootPrior prior = any;
    prior.slope = profile.slope;
    if (!windows.effects.empty()) prior.take(windows.effects[k]);
    slopes.fits[k] = fitFoundation(points, profile, level + profile.offset, prior);
    if (!windows.beams) return;
    rays[k] = countRays(points, profile, level + profile.offset, foot.reach);
    slopes.bands[k] = bandPointsOf(points, profile, level + profile.offset);
  });
  if (!windows.beams) return slopes;
  slopes.pooled_steepness = pooledSteepness(rays, foot.reach);
  slopes.steepness = steepnessAlong(rays, slopes.pooled_steepness, foot.reach);
  slopes.ring_steepness = ringSteepness(rays, foot.reach);
  slopes.effects = findBeamEffects(rays, sections.whole.band_from, foot.reach, foot.scales.shell_noise);
  return slopes;
}

double scatterOf(const std::vector<FootFit>& fits) {
  std::vector<WeightedValue> own;
  for (const FootFit& fit : fits) {
    if (fit.valid()) own.push_back({fit.own, static_cast<double>(fit.points) * (1.0 - fit.row)});
  }
  return own.empty() ? 0.0 : weightedMedian(std::move(own));
}

}  // namespace tank_datum
