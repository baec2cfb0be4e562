#include "foot/hidden_strip.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kStrip = 0.02;     // of the reach
constexpr std::size_t kStrips = 20;

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

}  // namespace

std::size_t thinStrips(const std::vector<std::size_t>& points) {
  constexpr std::size_t kFewest = 3, kBeyond = 6;  // strips beside the shell, and those they are compared with
  constexpr double kThin = 0.65;                   // of the density beyond, in all together and in each
  constexpr double kChance = 2.0;                  // standard deviations of a number of points
  std::size_t thin = 0;
  double inner = 0.0, densest = 0.0;
  for (std::size_t k = 0; k + kBeyond <= points.size(); ++k) {
    const auto from = points.begin() + static_cast<std::ptrdiff_t>(k);
    const double usual = median(std::vector<double>(from, from + kBeyond));
    const double most = inner + kChance * std::sqrt(inner);
    if (k >= kFewest && densest < kThin * usual && most < kThin * usual * static_cast<double>(k)) thin = k;
    const auto here = static_cast<double>(points[k]);
    inner += here, densest = std::max(densest, here);
  }
  return thin;
}

double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels) {
  constexpr double kNoise = 4.0;   // of the surface, within which its points lie,
  constexpr double kBend = 0.002;  // and what it may be bent by, of the reach
  const double width = kStrip * foot.reach, near = foot.scales.nearest();
  const double within = kNoise * pass.sections.whole.noise + kBend * foot.reach;
  std::vector<std::size_t> points(kStrips, 0);
  for (const std::size_t i : stationsAbout(foot, pass)) {
    for (const FootPoint& p : foot.points[i]) {
      const double strip = (p.d - near) / width, off = p.z - levels[i] - pass.priors.slope[i] * p.d;
      if (strip < 0.0 || strip >= static_cast<double>(kStrips)) continue;
      if (std::abs(off) < within) ++points[static_cast<std::size_t>(strip)];
    }
  }
  const std::size_t thin = thinStrips(points);
  return thin == 0 ? 0.0 : near + static_cast<double>(thin) * width;
}

}  // namespace tank_datum
