#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "foot/foot_check.h"
#include "foot/foot_profile.h"
#include "foot/foot_state.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// How many points each station's own stretch has on the surface, and whether it lies between points of its neighbours.
struct Support {
  std::size_t own = 0;
  bool between = false;
};

Support supportOf(const Foot& foot, std::size_t station, double level, const FootProfile& profile) {
  const double step = 2.0 * foot.half_step * foot.radius, azimuth = foot.directions[station];
  Support support;
  bool left = false, right = false;
  foot.ring.visitAround(azimuth, 2.0 * foot.half_step, level, foot.reach, [&](const FootPoint& p) {
    if (p.d < profile.band_from || p.d > profile.band_to) return;
    support.own += std::abs(p.t) <= 0.5 * step;
    (p.t < 0.0 ? left : right) = true;
  });
  support.between = left && right;
  return support;
}

/// A station is supported by points of its own; where the scan is so coarse that a stretch may be empty by chance, also
/// by points within a step on either side.
std::vector<bool> findSupport(const Foot& foot, const FootElevations& elevations, const FootSections& sections) {
  constexpr double kPlenty = 20.0;
  std::vector<Support> supports(foot.directions.size());
  forEachIndex(supports.size(), 0,
               [&](std::size_t i) { supports[i] = supportOf(foot, i, elevations.filled[i], sections.at(i)); });
  std::vector<double> counts;
  for (const Support& s : supports) {
    if (s.own > 0) counts.push_back(static_cast<double>(s.own));
  }
  const bool coarse = median(counts) < kPlenty;
  std::vector<bool> supported;
  for (const Support& s : supports) supported.push_back(s.own > 0 || (coarse && s.between));
  return supported;
}

}  // namespace

std::vector<bool> findOutliers(const Foot& foot, const FootElevations& elevations, const FootPass& pass) {
  const std::vector<bool> supported = findSupport(foot, elevations, pass.sections);
  std::vector<FootFit> kept = pass.fits;
  forEachIndex(kept.size(), 0, [&](std::size_t i) {
    if (!foot.shell_seen[i] || !kept[i].valid() || !supported[i] ||
        !isSameSurface(foot.points[i], kept[i], pass.priors.slope[i], pass.sections.at(i))) {
      kept[i] = {};
    }
  });
  std::vector<bool> outliers = findSteps(kept, 2.0 * foot.half_step * foot.radius);
  for (std::size_t i = 0; i < kept.size(); ++i) outliers[i] = outliers[i] || !kept[i].valid();
  return outliers;
}

std::vector<double> withoutOutliers(const std::vector<double>& elevations, const std::vector<bool>& outliers) {
  std::vector<double> kept = elevations;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (outliers[i]) kept[i] = kUnknown;
  }
  const auto known = [](double z) { return std::isfinite(z); };
  return 2 * std::count_if(kept.begin(), kept.end(), known) > std::count_if(elevations.begin(), elevations.end(), known)
             ? kept
             : elevations;
}

}  // namespace tank_datum
