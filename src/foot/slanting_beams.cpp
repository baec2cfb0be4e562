#include "foot/slanting_beams.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/statistics.h"
#include "foot/foot_profile.h"
#include "foot/ring_slope.h"

namespace tank_datum {
namespace {

constexpr double kFewestOnShell = 20.0;               // points, to tell how steeply it is seen
constexpr double kShellFrom = 0.1, kShellTo = 0.5;    // of the reach above the foot: the shell that is looked at
constexpr double kClearOf = 0.030, kClearTo = 0.090;  // beyond an edge, where no beam meets it too [m]

}  // namespace

bool isOnShell(const FootPoint& p, const FootProfile& profile, double level, double reach) {
  const double above = p.z - level;
  return std::abs(p.d) <= profile.blur && above >= kShellFrom * reach && above <= kShellTo * reach;
}

std::optional<double> steepnessBy(double points_a_metre, double on_shell, double reach) {
  if (on_shell < kFewestOnShell) return std::nullopt;
  return points_a_metre * (kShellTo * reach - kShellFrom * reach) / on_shell;
}

RayCounts countRays(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach) {
  constexpr double kSlopes = 0.1;  // a wide surface, at most [m/m]
  const double within = heightTolerance(profile);
  RayCounts counts;
  for (const FootPoint& p : points) {
    const double off = std::abs(p.z - level);
    if (p.d >= profile.band_from && off <= within + kSlopes * p.d)
      ++counts.wide, counts.wide_to = std::max(counts.wide_to, p.d);
    if (p.d >= profile.band_from && p.d <= profile.band_to && std::abs(p.z - level) <= within) ++counts.on_band;
    if (isOnShell(p, profile, level, reach)) ++counts.on_shell;
    if (p.d > profile.edge + kClearOf && p.d < profile.edge + kClearTo && p.z - level <= within) ++counts.beyond;
  }
  counts.beyond /= kClearTo - kClearOf;
  counts.a_metre = counts.on_band / (profile.band_to - profile.band_from);
  return counts;
}

double RayCounts::steepness(double reach) const {
  return steepnessBy(a_metre, on_shell, reach).value_or(0.0);  // not known: as if it grazed
}

double steepnessOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach) {
  return countRays(points, profile, level, reach).steepness(reach);
}

std::vector<double> pooledSteepness(const std::vector<RayCounts>& windows, double reach) {
  constexpr double kEnough = 50.0;  // points: of a few rows
  const std::size_t count = windows.size();
  std::vector<double> steepness;
  for (std::size_t i = 0; i < count; ++i) {
    RayCounts sum = windows[i];
    for (std::size_t away = 1; sum.on_band < kEnough && 2 * away < count; ++away) {
      sum.add(windows[(i + away) % count]);
      sum.add(windows[(i + count - away) % count]);
    }
    steepness.push_back(sum.steepness(reach));
  }
  return steepness;
}

std::vector<double> steepnessAlong(const std::vector<RayCounts>& windows, std::vector<double> steepness, double reach) {
  for (std::size_t i = 0; i < windows.size(); ++i) steepness[i] = std::min(steepness[i], windows[i].steepness(reach));
  return steepness;
}

double ringSteepness(const std::vector<RayCounts>& windows, double reach) {
  RayCounts sum;
  for (const RayCounts& w : windows) sum.add(w);
  if (sum.beyond > 0.0) sum.a_metre = std::min(sum.a_metre, sum.beyond);
  return sum.steepness(reach);
}

bool risesOutwards(const FootFit& fit) { return fit.slope > 3.0 * fit.sigma_slope; }

bool isGrazed(const std::vector<FootPoint>& points, const FootProfile& profile, const FootFit& fit, double reach) {
  constexpr double kAlong = 0.25;     // of the beams' slope; lips rise by a tenth of it at most
  constexpr double kRising = 0.25;    // of it: what lies farther out is seen from the shell's foot at such an angle
  constexpr std::size_t kFewest = 4;  // points of a bin
  constexpr double kBins = 30.0;      // of the reach
  if (!risesOutwards(fit)) return false;
  const double width = reach / kBins;
  std::vector<std::vector<double>> bins(static_cast<std::size_t>(kBins));
  double shell = 0;
  for (const FootPoint& p : points) {
    if (isOnShell(p, profile, fit.z, reach)) ++shell;
    if (p.d <= profile.edge || p.d >= reach) continue;
    bins[static_cast<std::size_t>(p.d / reach * kBins)].push_back(p.z - fit.z);
  }
  std::vector<double> counts;
  double sight = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].empty()) continue;
    counts.push_back(static_cast<double>(bins[i].size()));
    if (bins[i].size() >= kFewest) sight = std::max(sight, median(bins[i]) / (width * (static_cast<double>(i) + 0.5)));
  }
  const std::optional<double> beams = steepnessBy(median(counts) / width, shell, reach);
  return beams && fit.slope > kAlong * *beams && sight > kRising * *beams;
}

BandPoints bandPointsOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level) {
  constexpr double kEnd = 0.1;  // of the band, to either side of an end: what counts as there
  const double within = heightTolerance(profile), from = profile.band_from, to = profile.band_to;
  const double near = kEnd * (to - from);
  double count = 0, sum = 0, at_from = 0, at_to = 0;
  std::vector<double> distances;
  for (const FootPoint& p : points) {
    if (std::abs(p.z - level - profile.slope * p.d) > within) continue;
    at_from += std::abs(p.d - from) < near;
    at_to += std::abs(p.d - to) < near;
    if (p.d < from || p.d > to) continue;
    count += 1.0, sum += p.d;
    distances.push_back(p.d);
  }
  BandPoints band;
  if (distances.empty()) return band;
  const double mean = sum / count;
  for (const double d : distances) band.squares += (d - mean) * (d - mean);
  const double weight_from = (mean - from) / (2.0 * near), weight_to = (to - mean) / (2.0 * near);
  band.short_of = count - weight_from * at_from - weight_to * at_to;
  band.variance = count + weight_from * weight_from * at_from + weight_to * weight_to * at_to;
  return band;
}

double feignedSlope(const BandPoints& points, double steepness, double noise, double scatter) {
  if (!(points.squares > 0.0)) return 0.0;
  const double moved = noise * std::min(steepness * noise, scatter);
  return moved * std::hypot(points.short_of, std::sqrt(points.variance)) / points.squares;
}

double beamLean(double steepness, double lip) {
  constexpr double kBeam = 0.010;  // wide at the foot: 5 mm at the exit, 0.3 mrad over 15 m [m]
  return std::max(0.0, kBeam / lip - steepness);
}

double ringBeamLean(double steepness, double lip, double largest_weld) {
  constexpr double kBeam = 0.009;  // as beamLean's, of lips from the weld's toe on [m]
  constexpr double kWeld = 0.5;    // of the largest, as usual
  constexpr double kEnds = 0.5;    // of the lip: footprints shorter by so much feign nothing
  const double slope = kBeam / (lip - kWeld * largest_weld),
               shorter = steepness / slope - 1.0;  // by how much of a footprint
  const double ends = std::clamp(kEnds - shorter, 0.0, 2.0 * kEnds);
  return slope * (ends * ends / (4.0 * kEnds) + std::max(0.0, -shorter - kEnds));
}

namespace {

/// How far points on what a plate lies on are lifted 9 mm beyond the plate's edge, where their beams meet its edge too:
/// what beams at the shell's foot do as well.
struct LiftBeyond {
  double lift = 0, uneven = 0;  ///< [m]
  bool ramp = false;            ///< the plate comes down to what it lies on without a step: beams make that of it

  /// More than its unevenness explains, and as much as that may hide.
  double surely() const { return std::max(0.0, lift - 2.0 * uneven); }
  double atMost() const { return lift + uneven; }
};

/// Zero where the edge is sharp, or no drop is seen; any lift of one beyond which too little is seen.
LiftBeyond liftBeyond(const FootProfile& profile) {
  constexpr std::size_t kFewest = 4;                     // bins
  constexpr double kLeastDrop = 0.003, kBeside = 0.009;  // [m]
  const auto level = [&](std::size_t bin) { return profile.height[bin] - profile.slope_beyond * middle(profile, bin); };
  const double plate = profile.offset + (profile.slope - profile.slope_beyond) * profile.edge;
  std::vector<double> far, beside;
  bool drops = false;
  for (std::size_t i = 0; i < profile.height.size(); ++i) {
    const double beyond = middle(profile, i) - profile.edge;
    if (beyond > kClearOf && beyond < kClearTo && std::isfinite(level(i))) far.push_back(level(i));
    drops = drops || (beyond > 0.0 && beyond < kClearOf && level(i) < plate - kLeastDrop);
  }
  if (far.size() < kFewest) return {0.0, drops ? HUGE_VAL : 0.0};
  const double below = median(far);
  // points in a gap before a crown rise more steeply than any surface that a plate lies on
  if (!(plate - below > kLeastDrop) || profile.slope_beyond > kLipSlope)
    return {0.0, 0.0, std::abs(plate - below) <= kLeastDrop};
  const auto isBelow = [&](std::size_t i) { return level(i) < 0.5 * (plate + below); };
  auto face = static_cast<std::size_t>(profile.edge / profile.bin);
  while (face < profile.height.size() && !isBelow(face)) ++face;
  const double from = middle(profile, face) + std::max(kBeside, profile.blur) - 0.5 * profile.bin;
  for (std::size_t i = face; i < profile.height.size(); ++i) {
    const double d = middle(profile, i);
    if (isBelow(i) && d >= from && d < from + 2.0 * profile.bin) beside.push_back(level(i) - below);
  }
  if (beside.empty()) return {};
  return {std::max(0.0, median(beside)), robustSigma(far, below)};
}

}  // namespace

double blendLean(const FootProfile& profile, double most) {
  constexpr double kLean = 3.5;  // as lips lean on simulated scans whose beams are wide
  const LiftBeyond beyond = liftBeyond(profile);
  if (beyond.ramp) return std::max(most, profile.slope_beyond - profile.slope);
  const double of_lift = kLean / profile.edge;
  return std::max(of_lift * beyond.surely(), std::min(most, of_lift * beyond.atMost()));
}

double crownRise(const FootProfile& lip) {
  constexpr double kShare = 0.25;   // of the line's slope, as lips before crowns rise on simulated scans
  constexpr double kBeyond = 0.03;  // [m]
  const double end = seenTo(lip);
  std::vector<double> heights, distances;
  for (std::size_t i = 0; i < lip.height.size(); ++i) {
    const double d = middle(lip, i);
    if (d <= end || d > end + kBeyond || !std::isfinite(lip.height[i])) continue;
    heights.push_back(lip.height[i] - lip.offset - lip.slope * d), distances.push_back(d);
  }
  if (heights.empty()) return 0.0;
  const double higher = median(std::move(heights));
  return higher > 2.0 * lip.noise ? kShare * higher / (median(std::move(distances)) - lip.band_to) : 0.0;
}

SeriesValue blendedSlope(const SeriesValue& seen, double lip, double lean) {
  if (!std::isfinite(seen.value) || !std::isfinite(lip) || !(lean > 0.0)) return {0.0, 0.0, 1.0};
  const double known = lean / std::hypot(lean, seen.sigma);  // a normal distribution before and one of the errors
  return {known * known * std::clamp(seen.value - lip, -lean, 0.0), known * seen.sigma, 1.0};
}

double liftOf(double seen, double lip, double lean) {
  constexpr double kLift = 0.3;  // of the lean: what falls off with the square of the distance, in the lip's middle
  return lean > 0.0 && std::isfinite(seen) && std::isfinite(lip) ? kLift * std::abs(seen - lip) : 0.0;
}

}  // namespace tank_datum
