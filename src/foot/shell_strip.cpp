#include "foot/shell_strip.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/foot_roughness.h"

namespace tank_datum {
namespace {

/// Where a lip may be that the section does not show: up to the surface's own band, or a lip's edge [m].
double stripEnd(const FootProfile& profile) {
  return profile.surface == Surface::AnnularPlate ? std::max(profile.band_from, profile.edge) : profile.band_from;
}

/// How far from a place on hardly anything is seen, where it would be at a density; 0 where that may be chance.
/// @param values  what is seen, sorted
/// @param end  where what is seen begins at last
double emptyUpTo(const std::vector<double>& values, double from, double end, double density) {
  constexpr double kFew = 0.25;     // of as many as there would be
  constexpr double kEnough = 12.0;  // as many as there would be
  double empty = 0.0;
  for (std::size_t k = 0; k <= values.size(); ++k) {
    const double up_to = k < values.size() ? values[k] : end, wanted = density * (up_to - from);
    if (wanted >= kEnough && static_cast<double>(k) < kFew * wanted)
      empty = std::max(empty, (wanted - static_cast<double>(k)) / density);
  }
  return empty;
}

}  // namespace

ShellStrip stripAt(const Foot& foot, std::size_t station, const FootFit& fit, const FootProfile& profile) {
  constexpr double kBegins = 0.004;  // of the reach
  constexpr double kOnShell = 2.0;   // times its noise
  ShellStrip strip;
  if (!fit.valid()) return strip;
  strip.width = profile.band_to - profile.band_from;
  strip.noise = fit.noise;
  strip.blur = foot.scales.shell_noise;
  strip.on_plate = profile.surface == Surface::AnnularPlate;
  strip.from = std::max(kBegins * foot.reach, 2.5 * foot.scales.shell_noise);
  strip.to = stripEnd(profile);
  const double high = kStripHigh * foot.reach;
  for (const FootPoint& p : foot.points[station]) {
    const double height = offOf(p, fit);
    strip.surface += p.d >= profile.band_from && p.d <= profile.band_to && std::abs(height) < 2.0 * fit.noise;
    if (p.d >= strip.from && p.d < strip.to && std::abs(height) < high) strip.points.push_back({p.d, height});
    if (std::abs(p.d) <= kOnShell * foot.scales.shell_noise && height > 0.0 && height < high)
      strip.shell.push_back(height);
  }
  return strip;
}

ShellStrip together(const std::vector<ShellStrip>& strips, std::size_t station, const Foot& foot) {
  constexpr double kBeside = 1.0 * kDegree, kWidest = 15.0 * kDegree;
  constexpr double kEnough = 12.0;  // points of the narrowest lip; fewer than nine may be chance
  const std::size_t count = strips.size(), least = foot.stationsBeside(kBeside), most = foot.stationsBeside(kWidest);
  ShellStrip all = strips[station];
  const double enough = kEnough * all.width / (kNarrowestStrip * foot.reach);
  for (std::size_t k = 1; k <= most && (k <= least || all.surface < enough); ++k) {
    for (const std::size_t at : {(station + count - k) % count, (station + k) % count}) {
      if (!(strips[at].width > 0.0)) continue;
      all.points.insert(all.points.end(), strips[at].points.begin(), strips[at].points.end());
      all.shell.insert(all.shell.end(), strips[at].shell.begin(), strips[at].shell.end());
      all.surface += strips[at].surface;
    }
  }
  return all;
}

double shellEndsAt(const ShellStrip& strip, double reach) {
  std::vector<double> heights = strip.shell;
  std::sort(heights.begin(), heights.end());
  const double high = kStripHigh * reach, density = static_cast<double>(heights.size()) / high;
  const double height = emptyUpTo(heights, 0.0, high, density);
  return height > kLowestLip * reach ? height : 0.0;
}

double unseenHeight(const ShellStrip& strip, double reach) {
  if (!strip.valid()) return 0.0;
  std::vector<double> distances;
  for (const Beside& p : strip.points) distances.push_back(p.d);
  std::sort(distances.begin(), distances.end());
  const double gap = emptyUpTo(distances, strip.from, strip.to, strip.surface / strip.width);
  return gap < kNarrowestStrip * reach ? 0.0 : shellEndsAt(strip, reach);
}

}  // namespace tank_datum
