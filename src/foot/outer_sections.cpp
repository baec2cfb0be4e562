#include "foot/outer_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/statistics.h"
#include "fit/line_sums.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestBins = 2;  // that tell

/// How far bins of a section lie below the usual one, all together.
struct Depths {
  const Section& section;
  const UsualSection& usual;
  double weights = 0.0, below = 0.0, spread = 0.0;
  double far = 0.0;  ///< weighted distances, in bins
  std::vector<WeightedValue> bins = {};

  Depths(const Section& of, const UsualSection& among) : section(of), usual(among) {}
  void add(std::size_t bin) {
    if (!usual.tells(section, bin)) return;
    const double usually = usual.spread[bin], weight = 1.0 / (usually * usually);
    const double deep = usual.height[bin] - section[bin], away = static_cast<double>(bin) + 0.5;
    weights += weight, below += weight * deep, spread += weight * usually, far += weight * away;
    bins.push_back({deep - usual.falls * away, weight});
  }
  bool tell() const { return bins.size() >= kFewestBins; }
  /// @param falls  from bin to bin, which says nothing
  double mean(double falls) const { return (below - falls * far) / weights; }
  /// The same of most bins: a few in which an edge comes nearer, with what is far lower behind it, do not count.
  double ofMost() const { return std::min(mean(usual.falls), weightedMedian(bins)); }
  /// In what sections usually scatter by, which is not less for many bins: they err together.
  double standOut(double falls) const { return (below - falls * far) / spread; }
};

/// How much more a section falls from bin to bin than the usual one up to a bin, at most: a floor's slope differs round
/// the ring, but what lies on it ends in a step.
double fallsBefore(std::size_t end, const Section& section, const UsualSection& usual) {
  constexpr double kErrors = 2.0;
  double information = 0.0, sum = 0.0;
  for (std::size_t b = 0; b < std::min(end, section.size()); ++b) {
    if (!usual.tells(section, b)) continue;
    const double away = static_cast<double>(b) + 0.5, weight = 1.0 / (usual.spread[b] * usual.spread[b]);
    information += weight * away * away, sum += weight * away * (usual.height[b] - section[b]);
  }
  if (!(information > 0.0)) return usual.falls;
  return std::clamp(sum / information + kErrors / std::sqrt(information), 0.0, usual.falls);
}

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

/// Behind the last bin of the foundation beyond the surface: where the usual section leaves the line through those
/// before. The bin before that may hold the edge, which rows meet at one station and not at the next.
std::size_t endOfFoundation(const UsualSection& usual, std::size_t first) {
  constexpr double kOff = 3.0;  // times what sections scatter by
  LineSums line;
  std::size_t last = first, end = first;
  for (std::size_t b = first; b < usual.height.size(); ++b) {
    if (!std::isfinite(usual.height[b])) continue;
    const double at = static_cast<double>(b), slope = line.n > 2.0 ? line.slope() : 0.0;
    const double expected = line.n > 0.0 ? line.height() + slope * (at - line.distance()) : usual.height[b];
    if (std::abs(usual.height[b] - expected) > kOff * usual.spread[b]) return last;
    line.add(at, usual.height[b]);
    last = end, end = b + 1;
  }
  return end;
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
  constexpr double kNoise = 0.002;   // of the reach: what medians of bins scatter by at least
  constexpr double kFloors = 0.015;  // that a floor falls here and not there; what is heaped falls by more [m/m]
  RingSections ring{std::vector<Section>(levels.size()), {}};
  forEachIndex(levels.size(), 0, [&](std::size_t i) {
    if (std::isfinite(levels[i])) ring.own[i] = sectionAround(foot, levels, i, bins);
  });
  const std::size_t first = firstBeyond(foot, surface, bins);
  ring.usual = usualOf(ring.own, tells, first, bins, kNoise * foot.reach);
  if (foot.inside) ring.usual.falls = kFloors * foot.reach / static_cast<double>(bins);
  const bool on_lip = surface.surface == Surface::AnnularPlate;
  ring.usual.end = on_lip ? first : endOfFoundation(ring.usual, first);
  return ring;
}

}  // namespace

bool UsualSection::tells(const Section& section, std::size_t bin) const {
  return std::isfinite(height[bin]) && std::isfinite(section[bin]);
}

std::size_t UsualSection::told(const Section& section, std::size_t from, std::size_t to) const {
  std::size_t bins = 0;
  for (std::size_t b = from; b < std::min(to, section.size()); ++b) bins += tells(section, b) ? 1 : 0;
  return bins;
}

std::vector<RingSections> sectionsBeyond(const Foot& foot, const FootProfile& surface,
                                         const std::vector<double>& levels, const std::vector<bool>& tells) {
  std::vector<RingSections> all;
  bool whole = false;
  for (const std::size_t bins : {25U, 12U, 6U}) {
    RingSections ring = sectionsOf(foot, surface, levels, tells, bins);
    if (!whole && ring.usual.isWhole()) whole = true, all.clear();
    if (whole || all.empty()) all.push_back(std::move(ring));
    if (whole && surface.surface == Surface::AnnularPlate) break;  // upon a lip no part is asked for
  }
  return all;
}

SectionSeen::SectionSeen(const std::vector<RingSections>& all, std::size_t station)
    : narrowest_(&all.front()), shown_(narrowest_), station_(station) {
  const auto shows_most = [station](const RingSections& ring) {
    const UsualSection& usual = ring.usual;
    return 2 * usual.told(ring.own[station], 0, usual.end) > usual.told(usual.height, 0, usual.end);
  };
  const auto shown = std::find_if(all.begin(), all.end(), shows_most);
  if (shown != all.end()) shown_ = &*shown;
}

Depth SectionSeen::depth(double least) const {
  constexpr double kStands = 3.0;
  const Section& whole = narrowest_->own[station_];
  Depths all(whole, narrowest_->usual);
  for (std::size_t b = 0; b < whole.size(); ++b) all.add(b);
  Depth depth;
  if (!all.tell()) {
    depth.value = kUnknown;
  } else if (all.standOut(narrowest_->usual.falls) > kStands && all.ofMost() > least) {
    depth.value = all.ofMost();
  }
  const Section& own = shown_->own[station_];
  Depths part(own, shown_->usual);
  double clearest = std::max(kStands, depth.value > 0.0 ? all.standOut(narrowest_->usual.falls) : 0.0);
  for (std::size_t b = std::min(own.size(), shown_->usual.end); b-- > 0;) {
    part.add(b);
    const double falls = fallsBefore(b, own, shown_->usual);
    if (!part.tell() || part.standOut(falls) <= clearest || part.mean(falls) <= least) continue;
    clearest = part.standOut(falls);
    depth = {part.mean(falls), static_cast<double>(b) / static_cast<double>(own.size()), true};
  }
  return depth;
}

bool SectionSeen::shows(double from) const {
  const UsualSection& usual = shown_->usual;
  const auto first = static_cast<std::size_t>(std::floor(from * static_cast<double>(usual.height.size())));
  return usual.told(shown_->own[station_], first, from > 0.0 ? usual.end : usual.height.size()) >= kFewestBins;
}

}  // namespace tank_datum
