#include "setups/before_shell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "locate/side_sign.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

using ArcRadii = std::array<double, SetupRing::kArcs>;

/// The middle of the shell's radii in each arc, by setup [m]; unknown where a setup has none.
std::vector<ArcRadii> middlesOf(const SetupRing& ring, const BeforeShell::RadiusOf& radius_of, int threads) {
  constexpr std::size_t kArcs = SetupRing::kArcs, kCellsOfArc = SetupRing::kCells / kArcs;
  std::vector<std::vector<std::vector<double>>> radii(kArcs);  // by setup
  forEachIndex(kArcs, threads, [&](std::size_t arc) {
    const SetupRing::Entry* const end = ring.end((arc + 1) * kCellsOfArc - 1);
    for (const SetupRing::Entry* e = ring.begin(arc * kCellsOfArc); e < end; ++e) {
      const double radius = radius_of(*e);
      if (!std::isfinite(radius)) continue;
      if (e->setup >= radii[arc].size()) radii[arc].resize(e->setup + std::size_t{1});
      radii[arc][e->setup].push_back(radius);
    }
  });
  std::size_t setups = 0;
  for (const auto& arc : radii) setups = std::max(setups, arc.size());
  ArcRadii unknown;
  unknown.fill(kUnknown);
  std::vector<ArcRadii> middles(setups, unknown);
  for (std::size_t arc = 0; arc < kArcs; ++arc) {
    for (std::size_t s = 0; s < radii[arc].size(); ++s) {
      if (!radii[arc][s].empty()) middles[s][arc] = median(std::move(radii[arc][s]));
    }
  }
  return middles;
}

}  // namespace

BeforeShell::BeforeShell(const SetupRing& ring, const Tank& tank, double reach, const RadiusOf& radius_of,
                         int threads) {
  constexpr std::size_t kArcs = SetupRing::kArcs;
  constexpr std::size_t kBeside = 4;  // arcs
  constexpr double kBend = 0.01;      // of a shell, along it [m/m]
  constexpr double kClear = 0.01;     // plates, welds and noise [reach]
  const double length = kTwoPi * tank.circle.radius / static_cast<double>(kArcs);
  const double side = signOf(tank.side);
  const std::vector<ArcRadii> middles = middlesOf(ring, radius_of, threads);
  for (const ArcRadii& own : middles) {
    OfArcs& before = before_.emplace_back();
    before.fill(false);
    for (std::size_t arc = 0; arc < kArcs; ++arc) {
      const auto stands_out = [&](std::size_t beside, std::size_t apart) {
        const double clear = kClear * reach + kBend * length * static_cast<double>(apart);
        const double out = side * (own[arc] - own[beside]);
        return out > clear && std::any_of(middles.begin(), middles.end(), [&](const ArcRadii& other) {
                 return side * (other[arc] - other[beside]) < out - clear;
               });
      };
      for (std::size_t apart = 1; apart <= kBeside; ++apart)
        before[arc] =
            before[arc] || stands_out((arc + apart) % kArcs, apart) || stands_out((arc + kArcs - apart) % kArcs, apart);
    }
  }
}

bool BeforeShell::holds(const SetupRing::Entry& point) const {
  return point.setup < before_.size() && before_[point.setup][ringCell(point.azimuth, SetupRing::kArcs)];
}

}  // namespace tank_datum
