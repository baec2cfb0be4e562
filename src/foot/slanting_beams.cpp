#include "foot/slanting_beams.h"

#include <algorithm>
#include <cmath>

#include "foot/foot_profile.h"

namespace tank_datum {

double steepnessOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach) {
  const double within = 8.0 * profile.noise + profile.blur, from = 0.1 * reach, to = 0.5 * reach;
  double lip = 0, shell = 0;
  for (const FootPoint& p : points) {
    const double above = p.z - level;
    if (p.d >= profile.band_from && p.d <= profile.band_to && std::abs(above) <= within) ++lip;
    if (std::abs(p.d) <= profile.blur && above >= from && above <= to) ++shell;
  }
  if (shell < 20.0) return 0.0;  // not known: as if it grazed
  return lip / (profile.band_to - profile.band_from) * (to - from) / shell;
}

double beamLean(double steepness, double lip) {
  constexpr double kBeam = 0.010;  // wide at the foot: 5 mm at the exit, 0.3 mrad over 15 m [m]
  return std::max(0.0, kBeam / lip - steepness);
}

double liftOf(double seen, double lip, double lean) {
  constexpr double kLift = 0.3;  // of the lean: what falls off with the square of the distance, in the lip's middle
  return lean > 0.0 && std::isfinite(seen) && std::isfinite(lip) ? kLift * std::abs(seen - lip) : 0.0;
}

}  // namespace tank_datum
