#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "fit/circular_series.h"
#include "foot/foot_profile.h"
#include "foot/foot_state.h"

namespace tank_datum {
namespace {

constexpr std::size_t kArcs = 72;
constexpr std::size_t kFewestPoints = 3'000;  // for a section in fifty bins of sixty
constexpr std::size_t kMostPoints = 20'000;   // more sharpen no edge

/// The stations of an arc, as wide as a section needs; empty when that is no arc any more.
std::vector<std::size_t> arcAround(const Foot& foot, std::size_t middle, const std::vector<double>& datum) {
  const std::size_t count = foot.directions.size();
  const std::size_t widest = count / 12, narrowest = std::max<std::size_t>(1, count / kArcs);
  std::vector<std::size_t> members;
  std::size_t points = 0;
  for (std::size_t away = 0; away <= widest; ++away) {
    if (away > narrowest && points >= kFewestPoints) return members;
    for (const std::size_t i : {(middle + away) % count, (middle + count - away) % count}) {
      if ((away == 0 && !members.empty()) || !std::isfinite(datum[i])) continue;
      members.push_back(i);
      points += foot.points[i].size();
    }
  }
  return points >= kFewestPoints ? members : std::vector<std::size_t>{};
}

FootProfile sectionOf(const Foot& foot, const std::vector<std::size_t>& members, const std::vector<double>& datum,
                      const FootProfile& whole) {
  std::size_t total = 0;
  for (const std::size_t i : members) total += foot.points[i].size();
  const std::size_t every = std::max<std::size_t>(1, total / kMostPoints);
  std::vector<std::vector<FootPoint>> points;
  std::vector<double> levels;
  for (const std::size_t i : members) {
    points.emplace_back();
    for (std::size_t k = 0; k < foot.points[i].size(); k += every) points.back().push_back(foot.points[i][k]);
    levels.push_back(datum[i]);
  }
  FootScales scales = foot.scales;
  scales.arc = true;
  scales.overhang = whole.overhang;
  return stackProfile(points, levels, scales);
}

/// Whether a section shows its band in three of four bins. A row of the scan that runs along the lip over an arc shows
/// a part of it that is as wide as the row's noise, and leans along its rays.
bool showsBand(const FootProfile& section) {
  std::size_t bins = 0, seen = 0;
  for (std::size_t i = 0; i < section.height.size() && middle(section, i) < section.band_to; ++i) {
    if (middle(section, i) < section.band_from) continue;
    ++bins;
    seen += std::isfinite(section.height[i]) ? 1U : 0U;
  }
  return 4 * seen >= 3 * bins;
}

/// Whether a section of an arc shows the surface that the whole ring's does: not a heap that lies on it, nor what lies
/// behind it where the arc has too few points on it.
bool isAlike(const FootProfile& arc, const FootProfile& whole, double reach) {
  constexpr double kWider = 1.5;   // than the whole ring's lip: its edge is not seen there, not gone
  constexpr double kSlope = 0.08;  // of lips, which lean more than wide surfaces do [m/m]
  constexpr double kNoise = 2.5;
  constexpr double kLevel = 0.004;  // of the reach
  if (whole.surface == Surface::AnnularPlate && (showsBand(arc) ? arc.band_to : arc.edge) > kWider * whole.edge)
    return false;
  return arc.valid() && arc.noise < kNoise * whole.noise && std::abs(arc.slope - whole.slope) < kSlope &&
         std::abs(arc.offset - whole.offset) < kLevel * reach;
}

}  // namespace

const FootProfile& FootSections::at(std::size_t station) const {
  return arcs.empty() ? whole : arcs[station * arcs.size() / stations];
}

bool isOfLevel(const FootProfile& section, double reach) {
  constexpr double kLevel = 0.01;  // of the reach; plate, ringwall and crown are further apart
  return section.valid() && std::abs(section.offset) < kLevel * reach;
}

FootSections heldTo(const FootSections& before, FootSections now, double reach) {
  if (!before.whole.valid() || isOfLevel(now.whole, reach)) return now;
  FootSections held = before;
  const double off = now.whole.valid() && std::isfinite(now.whole.offset) ? now.whole.offset : 0.0;
  const bool below_lip = before.whole.surface == Surface::AnnularPlate && off < 0.0;
  if (!below_lip) held.other_level = std::abs(off);
  return held;
}

FootElevations alignedElevations(const Foot& foot, FootElevations elevations) {
  constexpr double kSurfaces = 0.1;  // of the reach: crown, plate and ringwall are no farther apart; a face is higher
  const FootProfile section = stackProfile(foot.points, elevations.known, foot.scales);
  if (!isResolved(foot) || !section.valid() || isOfLevel(section, foot.reach)) return elevations;
  forEachIndex(elevations.known.size(), 0, [&](std::size_t i) {
    if (!std::isfinite(elevations.known[i])) return;
    std::vector<double> off;
    for (const FootPoint& p : foot.points[i]) {
      const double bin = p.d / section.bin;
      if (p.d < foot.scales.nearest() || bin >= static_cast<double>(section.height.size())) continue;  // the shell's
      const double height = section.height[static_cast<std::size_t>(bin)];
      if (std::abs(height) < kSurfaces * foot.reach) off.push_back(p.z - elevations.known[i] - height);
    }
    if (!off.empty()) elevations.known[i] += median(off);
  });
  elevations.filled = filledUp(elevations.known);
  return elevations;
}

FootSections stackSections(const Foot& foot, const std::vector<double>& elevations) {
  FootSections sections;
  sections.stations = foot.directions.size();
  sections.whole = stackProfile(foot.points, elevations, foot.scales);
  const FootProfile& whole = sections.whole;
  if (!whole.valid()) return sections;
  sections.arcs.resize(kArcs);
  forEachIndex(kArcs, 0, [&](std::size_t k) {
    const std::size_t middle = std::min(sections.stations - 1, (2 * k + 1) * sections.stations / (2 * kArcs));
    const std::vector<std::size_t> members = arcAround(foot, middle, elevations);
    FootProfile& arc = sections.arcs[k];
    arc = members.empty() ? whole : sectionOf(foot, members, elevations, whole);
    if (!isAlike(arc, whole, foot.reach)) arc = whole;
    // a lip that ends where the ring's begins to be plain goes by what is plain of itself
    if (arc.band_to > whole.band_from) arc.band_from = std::max(arc.band_from, whole.band_from);
  });
  const auto ends = [](const FootProfile& arc) { return arc.surface != Surface::Foundation; };
  if (2 * std::count_if(sections.arcs.begin(), sections.arcs.end(), ends) < static_cast<std::ptrdiff_t>(kArcs)) {
    sections.arcs.clear();
  }
  return sections;
}

FootSections stackKnown(const Foot& foot, const std::vector<double>& known, const std::vector<double>& fitted) {
  FootSections sections = stackSections(foot, known);
  return sections.whole.valid() || fitted.empty() ? sections : stackSections(foot, fitted);
}

}  // namespace tank_datum
