#include "foot/hidden_strip.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "foot/section_lines.h"

namespace tank_datum {
namespace {

constexpr double kStrip = 0.02;  // of the reach
constexpr std::size_t kStrips = 20;
constexpr std::size_t kBeyond = 6;  // strips that those beside the shell are compared with

double pointsIn(const FootStrip& strip) { return static_cast<double>(strip.size()); }

/// How many strips beside the shell have less than two thirds of the points of those beyond, all together and each; 0:
/// none.
std::size_t thinStrips(const std::vector<FootStrip>& strips) {
  constexpr std::size_t kFewest = 3;
  constexpr double kThin = 0.65;
  constexpr double kChance = 2.0;  // standard deviations of a number of points
  std::size_t thin = 0;
  double inner = 0.0, densest = 0.0;
  for (std::size_t k = 0; k + kBeyond <= strips.size(); ++k) {
    std::vector<double> beyond;
    for (std::size_t j = k; j < k + kBeyond; ++j) beyond.push_back(pointsIn(strips[j]));
    const double usual = kThin * median(std::move(beyond)), most = inner + kChance * std::sqrt(inner);
    if (k >= kFewest && densest < usual && most < usual * static_cast<double>(k)) thin = k;
    inner += pointsIn(strips[k]), densest = std::max(densest, pointsIn(strips[k]));
  }
  return thin;
}

/// The line through the heights in some strips, against the strip's number.
/// @param bend  by which it may rise from strip to strip [m]
SectionLine lineOf(const std::vector<FootStrip>& strips, BinRange range, double bend) {
  std::vector<SectionBin> bins;
  for (std::size_t k = range.first; k < range.last; ++k) {
    const FootStrip& heights = strips[k];
    if (heights.empty()) continue;
    const double z = median(heights), error = kMedianOverMean * robustSigma(heights, z) / std::sqrt(pointsIn(heights));
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

/// What points of some strips scatter by, usually [m].
double scatterOf(const std::vector<FootStrip>& strips, BinRange range) {
  FootStrip all;
  for (std::size_t k = range.first; k < range.last; ++k) all.insert(all.end(), strips[k].begin(), strips[k].end());
  return robustSigma(all, median(all));
}

/// Whether points of some strips beside the shell scatter far more than those beyond, as on no one surface.
bool areScattered(const std::vector<FootStrip>& strips, std::size_t count) {
  constexpr double kMore = 2.0;
  return scatterOf(strips, {0, count}) > kMore * scatterOf(strips, {count, count + kBeyond});
}

}  // namespace

std::size_t hiddenStrips(const std::vector<FootStrip>& strips, double bend) {
  const std::size_t thin = thinStrips(strips);
  return thin > 0 && (areOff(strips, thin, bend) || areScattered(strips, thin)) ? thin : 0;
}

double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels) {
  constexpr double kNoise = 4.0;   // of the surface, within which its points lie,
  constexpr double kBend = 0.002;  // and what it may be bent by, of the reach
  const double width = kStrip * foot.reach, near = foot.scales.nearest(), bend = kBend * foot.reach;
  const double within = kNoise * pass.sections.whole.noise + bend;
  std::vector<FootStrip> strips(kStrips);
  // a station that has points of what is mostly hidden stands, its neighbours that have none do not
  const std::vector<bool> about = closeTo(foot, elevationsOf(standing(pass.fits, pass.outliers.reasons)));
  for (std::size_t i = 0; i < about.size(); ++i) {
    if (!about[i]) continue;
    for (const FootPoint& p : foot.points[i]) {
      const double at = (p.d - near) / width, height = p.z - levels[i] - pass.priors.slope[i] * p.d;
      if (at < 0.0 || at >= static_cast<double>(kStrips) || std::abs(height) >= within) continue;
      strips[static_cast<std::size_t>(at)].push_back(height);
    }
  }
  const std::size_t hidden = hiddenStrips(strips, bend);
  return hidden == 0 ? 0.0 : near + static_cast<double>(hidden) * width;
}

}  // namespace tank_datum
