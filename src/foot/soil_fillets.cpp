#include "foot/soil_fillets.h"

#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "foot/part_levels.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// The parts of a surface, from the weld to where it ends, all as wide.
struct SurfaceParts {
  double from, width;  ///< [m]

  SurfaceParts(const Foot& foot, const FootProfile& section)
      : from(foot.scales.nearest()), width((section.edge - from) / static_cast<double>(kParts)) {}
};

/// How high a station's points lie above its elevation: in the middle, part by part, with their number for a weight.
/// @param most  what is farther off is something else [m]
PerPart<WeightedValue> levelsOf(const std::vector<FootPoint>& points, const FootFit& fit, const SurfaceParts& parts,
                                double most) {
  PerPart<std::vector<double>> heights;
  for (const FootPoint& p : points) {
    const double part = std::floor((p.d - parts.from) / parts.width), off = offOf(p, fit);
    if (part >= 0.0 && part < static_cast<double>(kParts) && std::abs(off) < most)
      heights[static_cast<std::size_t>(part)].push_back(off + fit.slope * p.d);
  }
  return mediansOf(std::move(heights));
}

/// How the section of an arc bends; NaN where few points tell [m].
struct Bend {
  double up = kUnknown;    ///< of the inner part, above the line through the others
  double rise = kUnknown;  ///< of the outer part above the one between
};

Bend bendIn(const std::vector<PerPart<WeightedValue>>& own, std::size_t first, std::size_t last) {
  const auto [inner, between, outer] = levelsIn(own, first, last);
  return {inner - 2.0 * between + outer, outer - between};
}

}  // namespace

std::vector<bool> findFillets(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept) {
  constexpr double kArc = 5.0 * kDegree;  // to either side, that is looked at together
  constexpr double kPlain = 3.0;          // times what arcs differ by, usually: somewhere in a run of them
  constexpr double kGap = 2.0 * kDegree;  // of a run
  constexpr double kMost = 0.1;           // of the reach
  constexpr double kOutside = 0.5;        // of a bend: a crown or kerb that comes nearer, not soil at the shell
  const std::size_t count = kept.size(), near = foot.stationsBeside(kArc);
  std::vector<bool> fillets(count, false);
  const SurfaceParts parts(foot, pass.sections.whole);
  if (pass.priors.settled || !(parts.width > 0.0)) return fillets;
  std::vector<PerPart<WeightedValue>> own(count, PerPart<WeightedValue>{});
  forEachIndex(count, 0, [&](std::size_t i) {
    if (kept[i].valid()) own[i] = levelsOf(foot.points[i], kept[i], parts, kMost * foot.reach);
  });
  std::vector<double> bends(count, kUnknown), rises(count, kUnknown);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (!kept[i].valid()) return;
    const Bend bend = bendIn(own, i + count - near, i + count + near);
    bends[i] = bend.up, rises[i] = bend.rise;
  });
  const double usual_rise = median(finiteOf(rises));
  const std::vector<double> known = finiteOf(bends);
  const double usual = median(known), scatter = robustSigma(known, usual);
  const double least = usual + kHeapFalls * parts.width + scatter;
  const double plain = usual + kHeapFalls * parts.width + kPlain * scatter;
  std::vector<char> bent;
  for (std::size_t i = 0; i < count; ++i) {
    const bool rises_outside = rises[i] - usual_rise > kOutside * (bends[i] - usual);
    bent.push_back(bends[i] > least && !rises_outside ? 1 : 0);
  }
  for (const RingRun& run : runsRound(bent, foot.stationsIn(kGap))) {
    bool is_plain = false;
    for (std::size_t k = run.first; k <= run.last; ++k) is_plain = is_plain || bends[k % count] > plain;
    for (std::size_t k = run.first; k <= run.last; ++k) fillets[k % count] = is_plain && kept[k % count].valid();
  }
  return fillets;
}

}  // namespace tank_datum
