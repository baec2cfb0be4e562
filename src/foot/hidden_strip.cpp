#include "foot/hidden_strip.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "foot/section_lines.h"

namespace tank_datum {
namespace {

constexpr double kStrip = 0.02;  // of the reach
constexpr std::size_t kStrips = 20;
constexpr std::size_t kBeyond = 6;  // strips that those beside the shell are compared with

/// Stations that stand, and those within a few degrees of one: a station that has points of what is mostly hidden
/// stands, its neighbours that have none do not.
std::vector<std::size_t> stationsAbout(const Foot& foot, const FootPass& pass) {
  constexpr double kAbout = 3.0 * kDegree;
  const std::size_t count = pass.fits.size(), about = std::min(foot.stationsIn(kAbout), (count - 1) / 2);
  std::vector<char> taken(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!pass.fits[i].valid() || pass.outliers.reasons[i] != Unmeasured::None) continue;
    for (std::size_t k = i + count - about; k <= i + count + about; ++k) taken[k % count] = 1;
  }
  std::vector<std::size_t> stations;
  for (std::size_t i = 0; i < count; ++i) {
    if (taken[i] != 0) stations.push_back(i);
  }
  return stations;
}

double onSurface(const FootStrip& strip) { return static_cast<double>(strip.heights.size()); }
double inAll(const FootStrip& strip) { return onSurface(strip) + static_cast<double>(strip.above); }

/// How many strips beside the shell have less than a share of the points that the surface has in those beyond, all
/// together and each; 0: none.
template <typename Count>
std::size_t thinStrips(const std::vector<FootStrip>& strips, double share, const Count& count) {
  constexpr std::size_t kFewest = 3;
  constexpr double kChance = 2.0;  // standard deviations of a number of points
  std::size_t thin = 0;
  double inner = 0.0, densest = 0.0;
  for (std::size_t k = 0; k + kBeyond <= strips.size(); ++k) {
    std::vector<double> beyond;
    for (std::size_t j = k; j < k + kBeyond; ++j) beyond.push_back(onSurface(strips[j]));
    const double usual = share * median(std::move(beyond)), most = inner + kChance * std::sqrt(inner);
    if (k >= kFewest && densest < usual && most < usual * static_cast<double>(k)) thin = k;
    const double here = count(strips[k]);
    inner += here, densest = std::max(densest, here);
  }
  return thin;
}

/// The line through the heights in some strips, against the strip's number.
/// @param bend  by which it may rise from strip to strip [m]
SectionLine lineOf(const std::vector<FootStrip>& strips, BinRange range, double bend) {
  std::vector<SectionBin> bins;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const std::vector<double>& heights = strips[k].heights;
    if (heights.empty()) continue;
    const double z = median(heights);
    const double error = kMedianOverMean * robustSigma(heights, z) / std::sqrt(onSurface(strips[k]));
    bins.push_back({static_cast<double>(k), z, std::max(error, 1e-7)});
  }
  return lineThrough(bins, {0, bins.size()}, bend);
}

/// Whether points of some strips beside the shell lie off the line through those beyond.
bool areOff(const std::vector<FootStrip>& strips, std::size_t count, double bend) {
  const SectionLine inner = lineOf(strips, {0, count}, bend), beyond = lineOf(strips, {count, count + kBeyond}, bend);
  const double error = std::sqrt(inner.variance + beyond.varianceAt(inner.middle));
  return std::abs(inner.height - beyond.at(inner.middle)) > bend + 3.0 * error;
}

}  // namespace

std::size_t hiddenStrips(const std::vector<FootStrip>& strips, double bend) {
  constexpr double kEmpty = 0.45;  // of the density beyond: plants would be seen
  constexpr double kThin = 0.65;
  const std::size_t empty = thinStrips(strips, kEmpty, inAll), thin = thinStrips(strips, kThin, onSurface);
  return empty > 0 ? empty : thin > 0 && areOff(strips, thin, bend) ? thin : 0;
}

double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels) {
  constexpr double kNoise = 4.0;   // of the surface, within which its points lie,
  constexpr double kBend = 0.002;  // and what it may be bent by, of the reach
  constexpr double kHigh = 0.15;   // of the reach: how high plants are looked for
  const double width = kStrip * foot.reach, near = foot.scales.nearest(), bend = kBend * foot.reach;
  const double within = kNoise * pass.sections.whole.noise + bend;
  std::vector<FootStrip> strips(kStrips);
  for (const std::size_t i : stationsAbout(foot, pass)) {
    for (const FootPoint& p : foot.points[i]) {
      const double at = (p.d - near) / width, height = p.z - levels[i] - pass.priors.slope[i] * p.d;
      if (at < 0.0 || at >= static_cast<double>(kStrips) || height < -within) continue;
      FootStrip& strip = strips[static_cast<std::size_t>(at)];
      if (height < within) {
        strip.heights.push_back(height);
      } else if (height < kHigh * foot.reach) {
        ++strip.above;
      }
    }
  }
  const std::size_t hidden = hiddenStrips(strips, bend);
  return hidden == 0 ? 0.0 : near + static_cast<double>(hidden) * width;
}

}  // namespace tank_datum
