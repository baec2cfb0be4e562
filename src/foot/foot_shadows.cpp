#include "foot/foot_shadows.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/slanting_beams.h"
#include "foot/slope_windows.h"

namespace tank_datum {
namespace {

/// Counts of points on shell and foundation show the tangent of the rays' angle over the cosine of that between them
/// and the section. Rays may come from the side, as between two setups, by 50 degrees.
constexpr double kFromTheSide = 0.64;

/// What is looked at every few degrees: the points on the surface, and how steeply they are seen.
struct Windows {
  std::size_t stride;  ///< stations between windows
  std::vector<FittedPoints> fits;
  std::vector<double> seen;       ///< steepness that the counts of points show; NaN where they show none
  std::vector<double> steepness;  ///< of the rays, as far as they may come from the side; NaN where not known
};

/// What the counts of points make of the rays' steepness. Between two setups rays come from far along the shell, which
/// shows few points then, as if they were steep. The foundation tells how far: its points lie the thinner the farther
/// the scanner stands, by the distance cubed, and rays are the flatter by the distance itself.
void limitSteepness(Windows& windows) {
  constexpr double kBest = 0.9;      // of the windows: in the others, before the setups, points lie densest
  constexpr double kStraight = 0.8;  // of that density: rays come straight
  constexpr double kUpper = 0.75;    // quantile of what straight rays show
  std::vector<double> counts, straight;
  for (const FittedPoints& w : windows.fits) counts.push_back(w.fit.valid() ? static_cast<double>(w.fit.points) : 0.0);
  const double dense = kStraight * quantile(counts, kBest);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] >= dense && std::isfinite(windows.seen[k])) straight.push_back(windows.seen[k]);
  }
  if (straight.empty()) return;
  const double steepest = kFromTheSide * quantile(straight, kUpper);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (!(counts[k] > 0.0)) continue;
    const double flat = steepest * portable::cbrt(std::min(1.0, counts[k] / dense));
    windows.steepness[k] = std::isfinite(windows.steepness[k]) ? std::min(windows.steepness[k], flat) : flat;
  }
}

Windows lookAtWindows(const Foot& foot, const FootPass& pass) {
  constexpr std::size_t kWindows = 72;
  const std::size_t count = pass.fits.size();
  Windows windows{std::max<std::size_t>(1, count / kWindows), {}, {}, {}};
  windows.fits.resize((count + windows.stride - 1) / windows.stride);
  windows.seen.resize(windows.fits.size(), kUnknown);
  forEachIndex(windows.fits.size(), 0, [&](std::size_t k) {
    const std::size_t i = k * windows.stride;
    if (!pass.fits[i].valid()) return;
    const FootProfile& profile = pass.sections.at(i);
    const double half = static_cast<double>(windows.stride) * foot.half_step, z = pass.fits[i].z;
    auto points = foot.ring.around(foot.directions[i], half, z, foot.reach);
    const double steepness = steepnessOf(points, profile, z + profile.offset, foot.reach);
    if (steepness > 0.0) windows.seen[k] = steepness;
    const FootFit fit = fitFoundation(points, profile, z + profile.offset, pass.priors.at(i));
    const auto beside = [&](const FootPoint& p) { return p.d < profile.band_from || p.d > profile.band_to; };
    points.erase(std::remove_if(points.begin(), points.end(), beside), points.end());
    points.shrink_to_fit();
    windows.fits[k] = {std::move(points), fit, steepness > 0.0 ? steepness + fit.slope : 0.0};
  });
  for (const double s : windows.seen) windows.steepness.push_back(kFromTheSide * s);
  limitSteepness(windows);
  return windows;
}

}  // namespace

SeenHeights seenHeights(double steepness, const Roughness& roughness) {
  constexpr int kSteps = 64;
  constexpr double kFar = 6.0;        // standard deviations
  constexpr double kGrazing = 0.001;  // of the surface's slopes: flatter rays meet its tops alone
  constexpr double kAlike = 1.16;     // neighbouring heights are alike, as Smith's are not: as if slopes were larger
  if (!(roughness.slopes() > 0.0)) return {0.0, roughness.heights};
  const double v = std::max(kGrazing, steepness / (kAlike * roughness.slopes()) / std::sqrt(2.0));
  const double hidden = 0.5 * (portable::exp(-v * v) / (std::sqrt(kPi) * v) - portable::erfc(v));
  // a height is seen as often as it is the greatest of so many
  double sum = 0, mean = 0, squares = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = kFar * (2.0 * i / kSteps - 1.0);
    const double weight =
        portable::exp(-0.5 * x * x) * portable::pow(0.5 * portable::erfc(-x / std::sqrt(2.0)), hidden);
    sum += weight, mean += weight * x, squares += weight * x * x;
  }
  mean /= sum;
  return {roughness.heights * mean, roughness.heights * std::sqrt(squares / sum - mean * mean)};
}

Roughness unshadowed(const Roughness& seen, double steepness) {
  if (!(seen.slopes() > 0.0)) return seen;  // smooth
  Roughness rough = seen;
  for (int i = 0; i < 5; ++i) rough.heights *= seen.heights / seenHeights(steepness, rough).spread;
  return rough;
}

std::vector<StationDatum> withShadowsDoubted(std::vector<StationDatum> stations, const Foot& foot,
                                             const FootPass& pass) {
  const Windows windows = lookAtWindows(foot, pass);
  const std::vector<double> seen_steepness = finiteOf(windows.seen);
  if (seen_steepness.empty()) return stations;
  const double usual = median(finiteOf(windows.steepness)), noise = median(seen_steepness) * foot.scales.shell_noise;
  const Roughness seen = roughnessOf(windows.fits, pass.sections.whole, noise);
  const Roughness rough = unshadowed(seen, usual);
  std::vector<double> doubts;
  for (const double s : windows.steepness) doubts.push_back(seenHeights(s > 0.0 ? s : usual, rough).lift);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double doubt = doubts[nearestWindow(i, windows.stride, doubts.size())];
    StationDatum& s = stations[i];
    if (s.flag != StationFlag::Missing) s.sigma_z = std::hypot(s.sigma_z, doubt);
  }
  return stations;
}

}  // namespace tank_datum
