#include "foot/foot_shadows.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/slanting_beams.h"

namespace tank_datum {
namespace {

/// Counts of points on shell and foundation show the tangent of the rays' angle over the cosine of that between them
/// and the section. Rays may come from the side, as between two setups, by 50 degrees.
constexpr double kFromTheSide = 0.64;

/// What is looked at every few degrees: the points on the surface, and how steeply they are seen.
struct Windows {
  std::size_t stride;  ///< stations between windows
  std::vector<FittedPoints> fits;
  std::vector<double> steepness;  ///< of the rays, as far as they may come from the side; NaN where not known
};

Windows lookAtWindows(const Foot& foot, const FootPass& pass) {
  constexpr std::size_t kWindows = 72;
  const std::size_t count = pass.fits.size();
  Windows windows{std::max<std::size_t>(1, count / kWindows), {}, {}};
  windows.fits.resize((count + windows.stride - 1) / windows.stride);
  windows.steepness.resize(windows.fits.size(), kUnknown);
  forEachIndex(windows.fits.size(), 0, [&](std::size_t k) {
    const std::size_t i = k * windows.stride;
    if (!pass.fits[i].valid()) return;
    const FootProfile& profile = pass.sections.at(i);
    const double half = static_cast<double>(windows.stride) * foot.half_step, z = pass.fits[i].z;
    auto points = foot.ring.around(foot.directions[i], half, z, foot.reach);
    const double steepness = steepnessOf(points, profile, z + profile.offset, foot.reach);
    if (steepness > 0.0) windows.steepness[k] = kFromTheSide * steepness;
    const FootFit fit = fitFoundation(points, profile, z + profile.offset, pass.priors.slope[i], pass.priors.at(i));
    const auto beside = [&](const FootPoint& p) { return p.d < profile.band_from || p.d > profile.band_to; };
    points.erase(std::remove_if(points.begin(), points.end(), beside), points.end());
    points.shrink_to_fit();
    windows.fits[k] = {std::move(points), fit};
  });
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
  Roughness rough = seen;
  for (int i = 0; i < 5; ++i) rough.heights *= seen.heights / seenHeights(steepness, rough).spread;
  return rough;
}

std::vector<StationDatum> withShadowsDoubted(std::vector<StationDatum> stations, const Foot& foot,
                                             const FootPass& pass) {
  const Windows windows = lookAtWindows(foot, pass);
  std::vector<double> known;
  std::copy_if(windows.steepness.begin(), windows.steepness.end(), std::back_inserter(known),
               [](double s) { return std::isfinite(s); });
  if (known.empty()) return stations;
  const double usual = median(known);
  const Roughness seen = roughnessOf(windows.fits, pass.sections.whole, usual / kFromTheSide * foot.scales.shell_noise);
  const Roughness rough = unshadowed(seen, usual);
  std::vector<double> doubts;
  for (const double s : windows.steepness) doubts.push_back(seenHeights(s > 0.0 ? s : usual, rough).lift);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double doubt = doubts[(i + windows.stride / 2) / windows.stride % doubts.size()];  // of the nearest window
    StationDatum& s = stations[i];
    if (s.flag != StationFlag::Missing) s.sigma_z = std::hypot(s.sigma_z, doubt);
  }
  return stations;
}

}  // namespace tank_datum
