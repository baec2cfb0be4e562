#include "foot/outer_sections.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestBins = 2;  // that tell

/// The section of a station and its neighbours, each relative to its own elevation.
Section sectionAround(const Foot& foot, const std::vector<double>& levels, std::size_t station, std::size_t bins) {
  constexpr std::size_t kBeside = 3, kFewest = 3,
                        kMost = 300;  // stations to either side, points of a bin, of a station
  constexpr double kHigh = 0.3;       // of the reach
  const std::size_t count = levels.size();
  std::vector<std::vector<double>> heights(bins);
  for (std::size_t k = 0; k <= 2 * kBeside; ++k) {
    const std::size_t i = (station + count + k - kBeside) % count;
    if (!std::isfinite(levels[i])) continue;
    const std::vector<FootPoint>& points = foot.points[i];
    for (std::size_t p = 0; p < points.size(); p += points.size() / kMost + 1) {
      const double height = points[p].z - levels[i], bin = points[p].d / foot.reach * static_cast<double>(bins);
      if (bin < 0.0 || bin >= static_cast<double>(bins) || std::abs(height) > kHigh * foot.reach) continue;
      heights[static_cast<std::size_t>(bin)].push_back(height);
    }
  }
  Section section;
  for (const auto& bin : heights) section.push_back(bin.size() < kFewest ? kUnknown : median(bin));
  return section;
}

/// Of the quartiles the nearer counts: soil over more than a quarter of the ring makes the lower one its own.
/// @param tells  which of the sections say what is usual
/// @param first  bin, before which the surface itself lies
UsualSection usualOf(const std::vector<Section>& sections, const std::vector<bool>& tells, std::size_t first,
                     std::size_t bins, double noise) {
  constexpr std::size_t kFewest = 10;   // sections of a bin
  constexpr double kShare = 0.25;       // and of those there are
  constexpr double kQuartile = 0.6745;  // of a normal distribution
  double known = 0.0;
  for (std::size_t i = 0; i < sections.size(); ++i) known += tells[i] && !sections[i].empty() ? 1.0 : 0.0;
  UsualSection usual{Section(bins, kUnknown), Section(bins, kUnknown)};
  for (std::size_t b = first; b < bins; ++b) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const Section& s = sections[i];
      if (tells[i] && !s.empty() && std::isfinite(s[b])) heights.push_back(s[b]);
    }
    usual.seen += heights.size() >= kFewest ? 1 : 0;
    usual.shared += heights.size() >= kFewest && 2.0 * static_cast<double>(heights.size()) > known ? 1 : 0;
    if (static_cast<double>(heights.size()) < std::max<double>(kFewest, kShare * known)) continue;
    usual.height[b] = median(heights);
    const double below = usual.height[b] - quantile(heights, 0.25), above = quantile(heights, 0.75) - usual.height[b];
    usual.spread[b] = std::hypot(noise, std::min(below, above) / kQuartile);
  }
  return usual;
}

/// Leaves out bins beside an edge: there rows of a scan show what lies before it at one station and what lies behind
/// at the next. (A shoulder goes on falling.)
void leaveOutEdges(UsualSection& usual, double bin_width) {
  constexpr double kSteep = 0.3;    // no foundation slopes so, nor what lies against it [m/m]
  constexpr double kSharper = 2.0;  // than what falls or rises on both sides
  const Section heights = usual.height;
  const auto rise = [&](std::size_t b) { return b + 1 < heights.size() ? heights[b + 1] - heights[b] : kUnknown; };
  for (std::size_t b = 0; b + 1 < heights.size(); ++b) {
    const double before = b == 0 ? kUnknown : std::abs(rise(b - 1)), after = std::abs(rise(b + 1));
    const double beside = std::isfinite(before) && std::isfinite(after) ? std::min(before, after) : 0.0;
    if (std::abs(rise(b)) > kSteep * bin_width + kSharper * beside) usual.height[rise(b) < 0.0 ? b : b + 1] = kUnknown;
  }
}

/// The first bin that the surface itself does not reach into, nor the blur of a lip's edge.
std::size_t firstBeyond(const Foot& foot, const FootProfile& surface, std::size_t bins) {
  constexpr double kFirst = 0.12;  // of the reach, where the surface goes on
  const double lip = surface.surface == Surface::AnnularPlate ? (surface.edge + surface.blur) / foot.reach : 0.0;
  constexpr double kRounding = 1e-9;
  return static_cast<std::size_t>(std::ceil(std::max(kFirst, lip) * static_cast<double>(bins) - kRounding));
}

/// @param tells  which stations say what is usual
RingSections sectionsOf(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels,
                        const std::vector<bool>& tells, std::size_t bins) {
  constexpr double kNoise = 0.002;  // of the reach: what medians of bins scatter by at least
  RingSections ring{std::vector<Section>(levels.size()), {}};
  forEachIndex(levels.size(), 0, [&](std::size_t i) {
    if (std::isfinite(levels[i])) ring.own[i] = sectionAround(foot, levels, i, bins);
  });
  ring.usual = usualOf(ring.own, tells, firstBeyond(foot, surface, bins), bins, kNoise * foot.reach);
  leaveOutEdges(ring.usual, foot.reach / static_cast<double>(bins));
  return ring;
}

}  // namespace

bool UsualSection::tells(const Section& section, std::size_t bin) const {
  return std::isfinite(height[bin]) && std::isfinite(section[bin]);
}

std::size_t UsualSection::told(const Section& section, std::size_t from) const {
  std::size_t bins = 0;
  for (std::size_t b = from; b < section.size(); ++b) bins += tells(section, b) ? 1 : 0;
  return bins;
}

std::vector<RingSections> sectionsBeyond(const Foot& foot, const FootProfile& surface,
                                         const std::vector<double>& levels, const std::vector<bool>& tells) {
  std::vector<RingSections> all;
  for (const std::size_t bins : {25U, 12U, 6U}) all.push_back(sectionsOf(foot, surface, levels, tells, bins));
  const auto first = std::find_if(all.begin(), all.end(), [](const auto& ring) { return ring.usual.isWhole(); });
  if (first == all.end()) return {all.front()};
  return {first, all.end()};
}

SectionSeen::SectionSeen(const std::vector<RingSections>& all, std::size_t station) {
  const auto shows_most = [station](const RingSections& ring) {
    return 2 * ring.usual.told(ring.own[station]) > ring.usual.told(ring.usual.height);
  };
  const auto shown = std::find_if(all.begin(), all.end(), shows_most);
  const RingSections& ring = shown == all.end() ? all.front() : *shown;
  section_ = &ring.own[station];
  usual_ = &ring.usual;
}

Depth SectionSeen::depth(double least) const {
  constexpr double kStands = 3.0;
  double weights = 0.0, below = 0.0, spread = 0.0, clearest = 0.0;
  std::size_t told = 0;
  Depth depth;
  for (std::size_t b = section_->size(); b-- > 0;) {
    if (!usual_->tells(*section_, b)) continue;
    const double off = usual_->height[b] - (*section_)[b], usually = usual_->spread[b];
    const double weight = 1.0 / (usually * usually);
    weights += weight, below += weight * off, spread += weight * usually;
    ++told;
    if (told < kFewestBins || below <= std::max({kStands, clearest}) * spread || below <= least * weights) continue;
    clearest = below / spread;
    depth = {below / weights, static_cast<double>(b) / static_cast<double>(section_->size())};
  }
  if (told < kFewestBins) depth.value = kUnknown;
  return depth;
}

bool SectionSeen::shows(double from) const {
  const auto first = static_cast<std::size_t>(std::floor(from * static_cast<double>(section_->size())));
  return usual_->told(*section_, first) >= kFewestBins;
}

}  // namespace tank_datum
