#include "foot/foot_roughness.h"

#include <algorithm>
#include <cmath>

namespace tank_datum {
namespace {

/// Variance of the means of a band's parts, beyond that of points that err alone, over the number of parts [m^2].
double roughnessIn(const std::vector<FittedPoints>& fits, const FootProfile& profile, std::size_t parts) {
  constexpr std::size_t kPlenty = 10;  // points of a part, on the average
  const double width = (profile.band_to - profile.band_from) / static_cast<double>(parts);
  double squares = 0, expected = 0, free = 0;
  for (const auto& [points, fit] : fits) {
    if (!fit.valid() || fit.points < kPlenty * parts) continue;
    std::vector<double> sums(parts, 0.0), counts(parts, 0.0);
    for (const FootPoint& p : points) {
      const double off = p.z - fit.z - fit.slope * p.d - fit.along * p.t - fit.bend * p.t * p.t;
      if (p.d < profile.band_from || p.d >= profile.band_to || std::abs(off) > 4.0 * fit.noise) continue;
      const auto part = std::min(parts - 1, static_cast<std::size_t>((p.d - profile.band_from) / width));
      sums[part] += off;
      counts[part] += 1.0;
    }
    double seen = 0;
    for (std::size_t k = 0; k < parts; ++k) {
      if (counts[k] < 1.0) continue;
      squares += sums[k] * sums[k] / (counts[k] * counts[k]);
      expected += fit.noise * fit.noise / counts[k];
      seen += 1.0;
    }
    free += std::max(0.0, seen - 1.0);  // the level is the fit's
  }
  if (free < 1.0) return 0.0;
  return std::max(0.0, squares - expected) / free / static_cast<double>(parts);
}

}  // namespace

double sharedRoughness(const std::vector<FittedPoints>& fits, const FootProfile& profile) {
  // patches of a surface may be as long as a third of the band or as short as a sixth
  return std::max(roughnessIn(fits, profile, 3), roughnessIn(fits, profile, 6));
}

}  // namespace tank_datum
