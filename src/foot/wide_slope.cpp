#include "foot/wide_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/adaptive_smooth.h"
#include "fit/harmonics.h"
#include "fit/ring_process.h"
#include "foot/slope_windows.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// The largest standard error of windows that tell a slope, where enough do; else that of all of them. Of one row of a
/// scan, range noise shows the slope of its rays.
double mostSigmaThatTells(const std::vector<FootFit>& fits, std::size_t fewest) {
  std::size_t tell = 0;
  for (const FootFit& fit : fits) tell += fit.valid() && fit.sigma_slope <= kSlopeVaries;
  return tell < fewest ? std::numeric_limits<double>::infinity() : kSlopeVaries;
}

/// Where windows show another slope than a ring of one tilt has there, as a part of a floor that settled does, that
/// slope, known as well as they and those beside them agree on it.
/// @param off  of windows that tell, from the ring's [m/m]; NaN of others
/// @param known  variance of the ring's slope at a window [m2/m2]
void followArcs(const Slopes& found, const std::vector<double>& off, double known, FootPriors& priors) {
  constexpr double kFar = 3.0;
  const std::size_t windows = off.size();
  const auto is_floors = [&](std::size_t k) { return off[k] > -kHeapFalls && off[k] < FootPriors::kSteepestFoot; };
  const auto is_off = [&](std::size_t k) {
    return is_floors(k) && std::abs(off[k]) > kFar * std::sqrt(known + square(found.fits[k].sigma_slope));
  };
  std::vector<SeriesValue> local;
  for (std::size_t k = 0; k < windows; ++k) {
    const bool beside = is_off((k + 1) % windows) || is_off((k + windows - 1) % windows);  // where slopes fade away
    const bool followed = is_off(k) || (beside && is_floors(k));
    local.push_back(followed ? SeriesValue{off[k], found.fits[k].sigma_slope, 1.0} : SeriesValue{0.0, 0.0, 1.0});
  }
  for (std::size_t i = 0; i < priors.slope.size(); ++i) {
    const BetweenValues at(local, i, found.stride);
    const double mean = at.mean(local, &SeriesValue::value);
    const std::size_t k = nearestWindow(i, found.stride, windows);
    const double nearest = local[k].value;
    // where neighbours differ the slope changes within a window, and what a station sees of it is not what is at it
    const double changes = std::max(std::abs(local[(k + 1) % windows].value - nearest),
                                    std::abs(local[(k + windows - 1) % windows].value - nearest));
    priors.slope[i] += mean;
    priors.sigma_slope[i] = std::hypot(std::hypot(priors.sigma_slope[i], at.mean(local, &SeriesValue::sigma)),
                                       nearest - mean, kEither * changes);
  }
}

}  // namespace

void learnWide(const Foot& foot, const FootElevations& elevations, const FootSections& sections, FootPriors& priors) {
  constexpr double kHalfWindow = 5.0 * kPi / 180.0;
  constexpr double kLeastSigma = 0.003;  // no foundation is plane to better than 3 mm in a metre [m/m]
  constexpr std::size_t kFewest = 6;
  SlopeWindows windows{36, kHalfWindow, kWideSlope, true};
  const Slopes first = fitSlopes(foot, elevations, sections, windows, priors.sigma_bend);
  windows.scatter = priors.scatter = scatterOf(first.fits);
  windows.effects = first.effects;
  windows.beams = false;  // which were looked at
  for (std::size_t i = 0; i < priors.slope.size(); ++i)
    priors.beams.push_back(first.effects[nearestWindow(i, first.stride, first.effects.size())]);
  const Slopes found = fitSlopes(foot, elevations, sections, windows, priors.sigma_bend);
  priors.rounding.scatter = priors.scatter;
  const double most = mostSigmaThatTells(found.fits, kFewest);
  std::vector<WeightedValue> seen;
  std::vector<double> all, azimuths, slopes, weights;
  for (const FootFit& fit : found.fits) {
    if (!fit.valid() || fit.sigma_slope > most) continue;
    seen.push_back({fit.slope, 1.0 / square(fit.sigma_slope)}), all.push_back(fit.slope);
  }
  if (seen.size() < kFewest) return;
  priors.seen = weightedMedian(std::move(seen));
  const double scatter = robustSigma(all, priors.seen);
  priors.sigma_seen = kMedianOverMean * scatter / std::sqrt(static_cast<double>(all.size()));
  std::vector<double> off(found.fits.size(), kUnknown);
  double formal = 0, mean = 0, feigned = 0, lifted = 0;
  for (std::size_t k = 0; k < found.fits.size(); ++k) {
    const FootFit& fit = found.fits[k];
    const double error = std::hypot(fit.sigma_slope, scatter);
    if (fit.valid() && fit.sigma_slope <= most) off[k] = fit.slope;
    if (!fit.valid() || fit.sigma_slope > most || std::abs(fit.slope - priors.seen) > kHeapFalls + 3.0 * error)
      continue;
    azimuths.push_back(foot.directions[k * found.stride]);
    slopes.push_back(fit.slope), weights.push_back(1.0 / square(error));
    formal += 1.0 / square(fit.sigma_slope), mean += weights.back();
    feigned += weights.back() * fit.row * fit.sigma_slope, lifted += weights.back() * fit.lifted.slope;
  }
  if (slopes.size() < kFewest) return;
  priors.feigned = feigned / mean, priors.lifted = lifted / mean;
  const auto count = static_cast<double>(slopes.size());
  for (double& w : weights) w *= count / mean;
  const PeriodicFit fit = fitHarmonics(azimuths, slopes, weights, {1, true, 0.02});
  const double unit = std::max(fit.sigma * fit.sigma, count / formal);  // variance of a window's slope
  const double among_windows = std::max(kLeastSigma * kLeastSigma, unit - count / formal);
  for (std::size_t i = 0; i < priors.slope.size(); ++i) {
    const Eigen::RowVectorXd row = harmonicRow(foot.directions[i], 1);
    priors.slope[i] = fit(foot.directions[i]);
    priors.sigma_slope[i] = std::sqrt(among_windows + unit * row.dot(row * fit.covariance) + square(priors.feigned));
  }
  if (!foot.inside) return;  // what falls otherwise outside may be soil
  for (std::size_t k = 0; k < off.size(); ++k) off[k] -= fit(foot.directions[k * found.stride]);
  followArcs(found, off, among_windows, priors);
}

}  // namespace tank_datum
