#include "foot/soil_fillets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr std::size_t kParts = 3;  // of the surface, from the weld to where it ends

/// Something of each part.
template <typename T>
using PerPart = std::array<T, kParts>;

/// The parts of a surface, all as wide.
struct SurfaceParts {
  double from, width;  ///< [m]

  SurfaceParts(const Foot& foot, const FootProfile& section)
      : from(foot.scales.nearest()), width((section.edge - from) / static_cast<double>(kParts)) {}
};

/// How high a station's points lie above its fit: in the middle, part by part, with their number for a weight.
/// @param most  what is farther off is something else [m]
PerPart<WeightedValue> levelsOf(const std::vector<FootPoint>& points, const FootFit& fit, const SurfaceParts& parts,
                                double most) {
  PerPart<std::vector<double>> heights;
  for (const FootPoint& p : points) {
    const double part = std::floor((p.d - parts.from) / parts.width), off = offOf(p, fit);
    if (part >= 0.0 && part < static_cast<double>(kParts) && std::abs(off) < most)
      heights[static_cast<std::size_t>(part)].push_back(off);
  }
  PerPart<WeightedValue> levels;
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto weight = static_cast<double>(heights[part].size());
    levels[part] = {median(std::move(heights[part])), weight};
  }
  return levels;
}

/// How far the inner part of an arc lies above the line through the others; NaN where few points tell [m].
double bendIn(const std::vector<PerPart<WeightedValue>>& own, std::size_t first, std::size_t last) {
  constexpr double kFewest = 10.0;
  PerPart<double> levels{};
  for (std::size_t part = 0; part < kParts; ++part) {
    std::vector<WeightedValue> of_arc;
    double points = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      const WeightedValue& level = own[k % own.size()][part];
      if (level.weight > 0.0) of_arc.push_back(level), points += level.weight;
    }
    levels[part] = points < kFewest ? kUnknown : weightedMedian(std::move(of_arc));
  }
  return levels[0] - 2.0 * levels[1] + levels[2];
}

}  // namespace

std::vector<bool> findFillets(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept) {
  constexpr double kArc = 5.0 * kDegree;  // to either side, that is looked at together
  constexpr double kPlain = 3.0;          // times what arcs differ by, usually: somewhere in a run of them
  constexpr double kGap = 2.0 * kDegree;  // of a run
  constexpr double kMost = 0.1;           // of the reach
  const std::size_t count = kept.size(), near = foot.stationsBeside(kArc);
  std::vector<bool> fillets(count, false);
  const SurfaceParts parts(foot, pass.sections.whole);
  if (pass.priors.settled || !(parts.width > 0.0)) return fillets;
  std::vector<PerPart<WeightedValue>> own(count, PerPart<WeightedValue>{});
  forEachIndex(count, 0, [&](std::size_t i) {
    if (kept[i].valid()) own[i] = levelsOf(foot.points[i], kept[i], parts, kMost * foot.reach);
  });
  std::vector<double> bends(count, kUnknown);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (kept[i].valid()) bends[i] = bendIn(own, i + count - near, i + count + near);
  });
  const std::vector<double> known = finiteOf(bends);
  const double usual = median(known), scatter = robustSigma(known, usual);
  const double least = usual + kHeapFalls * parts.width + scatter;
  const double plain = usual + kHeapFalls * parts.width + kPlain * scatter;
  std::vector<char> bent;
  for (const double bend : bends) bent.push_back(bend > least ? 1 : 0);
  for (const RingRun& run : runsRound(bent, foot.stationsIn(kGap))) {
    bool is_plain = false;
    for (std::size_t k = run.first; k <= run.last; ++k) is_plain = is_plain || bends[k % count] > plain;
    for (std::size_t k = run.first; k <= run.last; ++k) fillets[k % count] = is_plain && kept[k % count].valid();
  }
  return fillets;
}

}  // namespace tank_datum
