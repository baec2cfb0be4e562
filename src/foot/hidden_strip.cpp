#include "foot/hidden_strip.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "foot/ring_slope.h"
#include "foot/section_lines.h"

namespace tank_datum {
namespace {

constexpr std::size_t kNearest = 20;
constexpr std::size_t kFewest = 3;  // beside the shell that may be hidden
constexpr std::size_t kBeyond = 6;  // strips that those beside the shell are compared with

double pointsIn(const FootStrip& strip) { return static_cast<double>(strip.size()); }

/// How many strips beside the shell have less than two thirds of the points of those beyond, all together and each; 0:
/// none.
/// @param all  what those beyond have
/// @param of_shell  how many of those in the first strip are the shell's
std::size_t thinStrips(const std::vector<FootStrip>& strips, const std::vector<FootStrip>& all, double of_shell) {
  constexpr double kThin = 0.65;
  constexpr double kChance = 2.0;  // standard deviations of a number of points
  std::size_t thin = 0;
  double inner = 0.0, densest = 0.0;
  for (std::size_t k = 0; k + kBeyond <= strips.size(); ++k) {
    std::vector<double> beyond;
    for (std::size_t j = k; j < k + kBeyond; ++j) beyond.push_back(pointsIn(all[j]));
    const double usual = kThin * median(std::move(beyond)), most = inner + kChance * std::sqrt(inner);
    if (k >= kFewest && densest < usual && most < usual * static_cast<double>(k)) thin = k;
    const double points = pointsIn(strips[k]) - (k == 0 ? of_shell : 0.0);
    inner += points, densest = std::max(densest, points);
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

/// The strips beyond some that show the surface: up to one with far more points, which is an upright face.
BinRange beyond(const std::vector<FootStrip>& strips, std::size_t count) {
  constexpr double kFace = 2.0;  // times as many
  std::vector<double> points;
  for (std::size_t k = count; k < count + kBeyond; ++k) points.push_back(pointsIn(strips[k]));
  const double most = kFace * median(std::move(points));
  BinRange range{count, count};
  while (range.last < count + kBeyond && pointsIn(strips[range.last]) <= most) ++range.last;
  return range;
}

/// Whether points of some strips beside the shell lie off the line through those beyond.
bool areOff(const std::vector<FootStrip>& strips, std::size_t count, double bend) {
  const SectionLine inner = lineOf(strips, {0, count}, bend), outer = lineOf(strips, beyond(strips, count), bend);
  const double error = std::sqrt(inner.variance + outer.varianceAt(inner.middle));
  return std::abs(inner.height - outer.at(inner.middle)) > bend + 3.0 * error;
}

/// Whether the shell goes on below the line through the strips beyond some.
bool goesBelow(const FootStrip& shell, const std::vector<FootStrip>& strips, std::size_t count, double bend) {
  constexpr double kDeep = 15.0;  // times what the surface may be bent by, above the line and below
  const SectionLine outer = lineOf(strips, beyond(strips, count), bend);
  const double line = outer.at(0.0), deep = kDeep * bend;
  std::size_t below = 0, above = 0;
  for (const double height : shell) {
    below += height < line && height > line - deep;
    above += height > line && height < line + deep;
  }
  const double least = bend + 3.0 * std::sqrt(outer.varianceAt(0.0));
  return static_cast<double>(below) * deep > static_cast<double>(above) * least;
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
  return scatterOf(strips, {0, count}) > kMore * scatterOf(strips, beyond(strips, count));
}

/// Whether points of some strips beside the shell rise outwards more steeply than a foundation, to an edge that hides
/// it.
bool rises(const std::vector<FootStrip>& strips, std::size_t count, double width, double bend) {
  const SectionLine inner = lineOf(strips, {0, count}, bend);
  return inner.slope > kSteepestLip * width + 3.0 * std::sqrt(inner.variance_slope);
}

/// Whether the medians of strips lie on a line.
bool areStraight(const std::vector<FootStrip>& strips, const SectionLine& line, std::size_t count, double bend) {
  for (std::size_t k = 0; k < count; ++k) {
    if (std::abs(median(strips[k]) - line.at(static_cast<double>(k))) > bend) return false;
  }
  return true;
}

/// Whether what is seen beside the shell, as densely as in the strips beyond some, is a surface that meets the one in
/// these at a crest, and the shell lower than that drawn on to it: a bank's shoulder, with the foundation behind.
bool isShoulder(const FootStrips& seen, std::size_t count, double bend) {
  constexpr double kSeen = 0.65;  // of the points beyond, and of those there on the surface
  constexpr double kLower = 2.0;  // times what the surface may be bent by
  double beside = 0.0, all = 0.0;
  for (std::size_t k = 0; k < count; ++k) beside += pointsIn(seen.all[k]);
  for (std::size_t k = count; k < count + kBeyond; ++k) {
    all += pointsIn(seen.all[k]);
    if (pointsIn(seen.surface[k]) < kSeen * pointsIn(seen.all[k])) return false;
  }
  if (beside * static_cast<double>(kBeyond) < kSeen * all * static_cast<double>(count)) return false;
  const SectionLine inner = lineOf(seen.all, {0, count}, bend),
                    outer = lineOf(seen.surface, {count, count + kBeyond}, bend);
  const double error = std::sqrt(inner.variance + outer.varianceAt(inner.middle));
  const double crest = static_cast<double>(count) - 0.5, apart = std::abs(outer.at(crest) - inner.at(crest));
  return outer.at(inner.middle) - inner.height > kLower * bend + 3.0 * error && apart < kLower * bend &&
         areStraight(seen.all, inner, count, bend);
}

}  // namespace

std::size_t hiddenStrips(const FootStrips& seen, double bend) {
  const std::vector<FootStrip>& strips = seen.surface;
  const std::size_t thin = thinStrips(strips, strips, seen.of_shell);
  if (thin > 0 &&
      (areOff(strips, thin, bend) || areScattered(strips, thin) || goesBelow(seen.shell, strips, thin, bend)))
    return thin;
  for (std::size_t count = kFewest; count + kBeyond <= strips.size(); ++count) {
    if (isShoulder(seen, count, bend)) return count;
  }
  const std::size_t thinner = thinStrips(strips, seen.all, seen.of_shell);
  return thinner > 0 && rises(strips, thinner, seen.width, bend) ? thinner : 0;
}

StripScales stripScales(const Foot& foot, const FootPass& pass) {
  constexpr double kStrip = 0.02;                // wide, of the reach
  constexpr double kBend = 0.002;                // of the reach
  constexpr double kNoise = 4.0, kHigher = 2.0;  // of the surface
  const double noise = pass.sections.whole.noise, bend = kBend * foot.reach;
  return {foot.scales.nearest(), kStrip * foot.reach, bend, kNoise * noise + bend, kHigher * noise + bend};
}

double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels) {
  constexpr double kShell = 2.0;  // of the shell's noise, within which its points lie
  const StripScales scales = stripScales(foot, pass);
  FootStrips seen{scales.width, std::vector<FootStrip>(kNearest), std::vector<FootStrip>(kNearest), {}, 0.0};
  // a station that has points of what is mostly hidden stands, its neighbours that have none do not
  const std::vector<bool> about = closeTo(foot, elevationsOf(standing(pass.fits, pass.outliers.reasons)));
  for (std::size_t i = 0; i < about.size(); ++i) {
    if (!about[i]) continue;
    for (const FootPoint& p : foot.points[i]) {
      const double height = p.z - levels[i] - pass.priors.slope[i] * p.d;
      if (std::abs(p.d) <= kShell * foot.scales.shell_noise) seen.shell.push_back(height);
      const std::size_t strip = scales.stripAt(p.d, kNearest);
      if (strip == kNearest) continue;
      if (std::abs(height) < scales.within) seen.surface[strip].push_back(height);
      if (strip == 0 && height >= scales.within && height < 3.0 * scales.within) seen.of_shell += 1.0;
      seen.all[strip].push_back(height);
    }
  }
  seen.of_shell = std::min(seen.of_shell, pointsIn(seen.surface[0]));
  const std::size_t hidden = hiddenStrips(seen, scales.bend);
  return hidden == 0 ? 0.0 : scales.near + static_cast<double>(hidden) * scales.width;
}

}  // namespace tank_datum
