#include "foot/lip_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "foot/part_levels.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Which part of what is seen beyond a lip's edge a bin of the section is in; kParts: none, since it has no height of
/// its own, as an upright face.
struct SectionParts {
  std::vector<std::size_t> of_bin;
  double apart = 0.0;  ///< from the middle of the first to that of the last [m]

  bool valid() const { return apart > 0.0; }
};

SectionParts partsOf(const FootProfile& section) {
  constexpr double kSpread = 2.0;          // times the surface's noise
  constexpr std::size_t kFewestBins = 12;  // as wide as a narrow lip
  SectionParts parts;
  parts.of_bin.assign(section.height.size(), kParts);
  std::vector<std::size_t> bins;
  for (std::size_t bin = 0; bin < section.height.size(); ++bin) {
    const bool beyond = middle(section, bin) > section.edge + section.blur;
    if (beyond && std::isfinite(section.height[bin]) && section.spread[bin] <= kSpread * section.noise)
      bins.push_back(bin);
  }
  if (bins.size() < kFewestBins) return parts;
  for (std::size_t k = 0; k < bins.size(); ++k) parts.of_bin[bins[k]] = k * kParts / bins.size();
  parts.apart =
      static_cast<double>(kParts - 1) / kParts * section.bin * static_cast<double>(bins.back() - bins.front());
  return parts;
}

/// How high a station's points lie above the ring's section when that lies on the station's fit: in the middle, part by
/// part, with their number for a weight.
PerPart<WeightedValue> levelsOf(const std::vector<FootPoint>& points, const FootFit& fit, const FootProfile& section,
                                const SectionParts& parts, double most) {
  PerPart<std::vector<double>> heights;
  for (const FootPoint& p : points) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, p.d) / section.bin);
    if (bin >= parts.of_bin.size() || parts.of_bin[bin] == kParts) continue;
    const double height = offOf(p, fit) + fit.slope * p.d - (section.height[bin] - section.offset);
    if (std::abs(height) < most) heights[parts.of_bin[bin]].push_back(height);
  }
  return mediansOf(std::move(heights));
}

}  // namespace

LipCover findLipCover(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept) {
  constexpr double kArc = 5.0 * kDegree;  // to either side, that is looked at together
  constexpr double kSteeper = 0.02;       // the slope of what a lip lies on varies by less along the shell [m/m]
  constexpr double kLeast = 0.002;        // of the reach: its level does
  constexpr double kPlain = 3.0;          // times what arcs differ by, usually
  constexpr double kMost = 0.1;           // of the reach: what is farther off is an object
  constexpr double kMiddle = 0.25;        // of the fall, by the middle part
  const FootProfile& section = pass.sections.whole;
  const std::size_t count = kept.size(), near = foot.stationsBeside(kArc);
  LipCover cover{std::vector<bool>(count, false), std::vector<double>(count, 0.0)};
  const SectionParts parts = partsOf(section);
  if (!pass.priors.settled || !parts.valid()) return cover;
  std::vector<PerPart<WeightedValue>> own(count, PerPart<WeightedValue>{});
  forEachIndex(count, 0, [&](std::size_t i) {
    if (kept[i].valid()) own[i] = levelsOf(foot.points[i], kept[i], section, parts, kMost * foot.reach);
  });
  std::vector<PerPart<double>> levels(count);
  std::vector<double> falls(count, kUnknown), lows(count, kUnknown);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (!kept[i].valid()) return;
    levels[i] = levelsIn(own, i + count - near, i + count + near);
    falls[i] = levels[i].front() - levels[i].back();
    lows[i] = median(finiteOf(std::vector<double>(levels[i].begin(), levels[i].end())));
  });
  const std::vector<double> known_falls = finiteOf(falls), known_lows = finiteOf(lows);
  const double fall = median(known_falls), low = median(known_lows);
  const double most = fall + kSteeper * parts.apart + kPlain * robustSigma(known_falls, fall);
  const double lowest = low - kLeast * foot.reach - kPlain * robustSigma(known_lows, low);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [inner, between, outer] = levels[i];
    cover.covered[i] = falls[i] > most && inner < -outer && inner - between > kMiddle * falls[i];
    if (lows[i] < lowest) cover.maybe[i] = low - lows[i];
  }
  return cover;
}

}  // namespace tank_datum
