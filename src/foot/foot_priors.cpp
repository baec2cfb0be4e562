#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/adaptive_smooth.h"
#include "fit/circular_series.h"
#include "foot/foot_check.h"
#include "foot/foot_profile.h"
#include "foot/foot_state.h"
#include "foot/ring_slope.h"
#include "foot/slanting_beams.h"
#include "foot/slope_windows.h"
#include "foot/wide_slope.h"
#include "stations/highest_wave.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/foot/refined.h"

namespace tank_datum {
namespace {

/// The slope that range noise may feign in the windows together.
double feignedSlopeOf(const Slopes& found, double shell_noise) {
  BandPoints all;
  std::vector<double> steepness, scatter;
  for (std::size_t k = 0; k < found.fits.size(); ++k) {
    if (!found.fits[k].valid() || !(found.steepness[k] > 0.0)) continue;
    all.add(found.bands[k]);
    steepness.push_back(found.steepness[k]);
    scatter.push_back(found.fits[k].noise);
  }
  return steepness.empty() ? 0.0 : feignedSlope(all, median(steepness), shell_noise, median(scatter));
}

/// Windows far off those beside them, at the end of what is seen or where another thing reaches in, are known no better
/// than that.
void doubtStray(std::vector<SeriesValue>& series) {
  constexpr std::size_t kBeside = 3;
  constexpr double kFar = 3.0;
  std::vector<double> values, off;
  for (const SeriesValue& v : series) values.push_back(v.value);
  const std::vector<double> usual = runningMedian(values, kBeside);
  for (std::size_t k = 0; k < series.size(); ++k) {
    if (std::isfinite(values[k])) off.push_back(values[k] - usual[k]);
  }
  const double far = kFar * robustSigma(off, 0.0);
  for (std::size_t k = 0; k < series.size(); ++k) {
    const double away = std::abs(values[k] - usual[k]);
    if (away > far) series[k].sigma = std::max(series[k].sigma, away);
  }
}

/// Adds to the windows' errors what they leave out, roughness common to many points, as their scatter shows it.
/// @return what is added
double addCommonSigma(std::vector<SeriesValue>& series) {
  std::vector<FootFit> fits(series.size());
  for (std::size_t k = 0; k < series.size(); ++k) {
    if (std::isfinite(series[k].value)) fits[k].z = series[k].value, fits[k].sigma = series[k].sigma;
  }
  const double common = commonSigma(fits, 1);
  for (SeriesValue& v : series) v.sigma = std::hypot(v.sigma, common);
  return common;
}

/// Slopes of a lip window by window, each with the lean that its slanting rays may feign.
struct LipSlopes {
  std::size_t stride = 1;           ///< stations between windows
  std::vector<SeriesValue> seen;    ///< with the errors of what is seen
  std::vector<SeriesValue> series;  ///< with the lean in their errors
  std::vector<double> lean;
  std::vector<double> steepness;  ///< of the rays, 0: not known
  double ring_lean = 0;           ///< of all windows' rays together [m/m]
  double doubt = 0;               ///< the lean that range noise may feign, typical [m/m]
  double scatter = 0;             ///< of points about the lip [m]
  double uneven = 0;              ///< what slopes differ by beyond their errors and chance [m/m]
  double common = 0;              ///< in the errors of all windows, as their scatter shows it [m/m]
};

LipSlopes lipSlopes(const Foot& foot, const FootElevations& elevations, const FootSections& sections,
                    double sigma_bend) {
  constexpr double kAnySlope = 0.5;  // of a window, which is to say what its own points do [m/m]
  constexpr double kByChance = 0.7;  // of a variance: two standard errors of one that some thirty differences tell
  const Slopes found = fitSlopes(foot, elevations, sections, {72, 0.5 * kSlopeWindow, kAnySlope, true}, sigma_bend);
  if (std::none_of(found.fits.begin(), found.fits.end(), [](const FootFit& fit) { return fit.valid(); })) return {};
  LipSlopes lips;
  lips.scatter = scatterOf(found.fits);
  for (const FootFit& fit : found.fits) {
    lips.series.push_back({kUnknown, kUnknown, 1.0});
    if (!fit.valid()) continue;
    lips.series.back() = {fit.slope, std::max(fit.sigma_slope, 1e-6), 1.0};
  }
  doubtStray(lips.series);
  std::vector<double> variances;
  for (const SeriesValue& v : lips.series) {
    if (std::isfinite(v.value)) variances.push_back(square(v.sigma));
  }
  lips.common = addCommonSigma(lips.series);
  lips.uneven = std::sqrt(std::max(0.0, square(lips.common) - kByChance * median(variances)));
  lips.seen = lips.series;
  for (std::size_t k = 0; k < lips.series.size(); ++k) {
    lips.lean.push_back(beamLean(found.steepness[k], sections.whole.band_to));
    lips.series[k].sigma = std::hypot(lips.series[k].sigma, lips.lean.back());
  }
  const FootProfile& whole = sections.whole;
  const double width =
      std::max(whole.band_to, seenTo(whole) - whole.blur);  // as it is seen: its plain band may be less
  lips.ring_lean = ringBeamLean(found.ring_steepness, width, foot.scales.weld);
  lips.stride = found.stride;
  lips.steepness = found.pooled_steepness;
  lips.doubt = feignedSlopeOf(found, 0.25 * sections.whole.blur);
  return lips;
}

/// What beams feign of each window's slope, as neighbours agree on it.
/// @param slopes  of the lip there
std::vector<SeriesValue> blendedSlopes(const LipSlopes& lips, const std::vector<SeriesValue>& slopes) {
  constexpr std::size_t kWidest = 4;
  std::vector<SeriesValue> blended = smoothed(lips.seen, kWidest);
  for (std::size_t k = 0; k < blended.size(); ++k) {
    blended[k] = blendedSlope(blended[k], slopes[k].value, lips.lean[k]);
  }
  return blended;
}

/// The slope of a narrow surface, window by window.
void learnNarrow(const Foot& foot, const FootElevations& elevations, const FootSections& sections, FootPriors& priors) {
  constexpr double kLeastSigma = 0.001;  // what blends and roughness do to the slope of a lip [m/m]
  const LipSlopes lips = lipSlopes(foot, elevations, sections, priors.sigma_bend);
  if (lips.series.empty()) return;
  priors.rounding.scatter = lips.scatter;
  priors.uneven = lips.uneven;
  const FootProfile& whole = sections.whole;
  const ExpectedSlope expected{whole.slope_beyond, lips.doubt, blendLean(whole, lips.ring_lean), crownRise(whole),
                               whole.sigma_beyond};
  auto [ring, slopes] = drawTogether(lips.seen, lips.series, lips.common, expected);
  priors.seen = ring.seen, priors.sigma_seen = ring.sigma_seen;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    slopes[k].sigma += liftOf(lips.series[k].value, slopes[k].value, lips.lean[k]);
  }
  const double least = std::hypot(kLeastSigma, ring.sigma);  // what the windows together leave open
  const std::vector<SeriesValue> blended = blendedSlopes(lips, slopes);
  BlendedLip& blends = priors.blends;
  blends.level_at = 0.5 * (foot.scales.nearest() + seenTo(whole));
  blends.slope.assign(priors.slope.size(), 0.0), blends.sigma = blends.slope;
  for (std::size_t i = 0; i < priors.slope.size(); ++i) {
    const BetweenValues at(slopes, i, lips.stride);
    priors.steepness.push_back(lips.steepness[nearestWindow(i, lips.stride, lips.steepness.size())]);
    if (!at.known()) continue;
    priors.slope[i] = at.mean(slopes, &SeriesValue::value);
    priors.sigma_slope[i] = std::hypot(least, at.mean(slopes, &SeriesValue::sigma));
    blends.slope[i] = at.mean(blended, &SeriesValue::value);
    blends.sigma[i] = at.mean(blended, &SeriesValue::sigma);
  }
}

}  // namespace

FootFit BlendedLip::without(FootFit fit, std::size_t station) const {
  if (slope.empty() || !fit.valid()) return fit;
  const double beside = fit.middle - level_at;
  fit.z -= slope[station] * beside;
  fit.sigma = std::hypot(fit.sigma, sigma[station] * beside);
  return fit;
}

FootPrior FootPriors::at(std::size_t station) const {
  FootPrior prior;
  prior.slope = slope[station];
  prior.sigma_slope = sigma_slope[station];
  prior.sigma_bend = sigma_bend;
  prior.scatter = scatter;
  prior.rounding = rounding;
  if (!beams.empty()) prior.take(beams[station]);
  return prior;
}

double FootPriors::steepnessAt(std::size_t station) const {
  const bool known = !steepness.empty() && steepness[station] > 0.0;
  return known ? steepness[station] : std::numeric_limits<double>::infinity();
}

FootPriors learnPriors(const Foot& foot, const FootElevations& elevations, const FootSections& sections) {
  const bool narrow = sections.whole.surface == Surface::AnnularPlate;
  FootPriors priors;
  priors.slope.assign(foot.directions.size(), sections.whole.slope);
  priors.sigma_slope.assign(foot.directions.size(), narrow ? kLipSlope : kWideSlope);
  priors.sigma_bend = kHighestWave / foot.radius;
  priors.rounding.step = foot.rounding;
  priors.settled = narrow;
  narrow ? learnNarrow(foot, elevations, sections, priors) : learnWide(foot, elevations, sections, priors);
  return priors;
}

}  // namespace tank_datum
