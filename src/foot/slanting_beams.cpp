#include "foot/slanting_beams.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "foot/foot_profile.h"

namespace tank_datum {

double steepnessOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach) {
  const double within = heightTolerance(profile), from = 0.1 * reach, to = 0.5 * reach;
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

double blendBeyond(const FootProfile& profile) {
  constexpr double kLeastDrop = 0.003, kBeside = 0.009;  // [m]
  constexpr double kFar = 0.030, kEnd = 0.090;           // where no beam meets the edge too [m]
  const auto level = [&](std::size_t bin) { return profile.height[bin] - profile.slope_beyond * middle(profile, bin); };
  std::vector<double> far, beside;
  for (std::size_t i = 0; i < profile.height.size(); ++i) {
    const double beyond = middle(profile, i) - profile.edge;
    if (beyond > kFar && beyond < kEnd && std::isfinite(level(i))) far.push_back(level(i));
  }
  const double below = median(far), plate = profile.offset + (profile.slope - profile.slope_beyond) * profile.edge;
  if (far.empty() || !(plate - below > kLeastDrop)) return 0.0;
  const auto isBelow = [&](std::size_t i) { return level(i) < 0.5 * (plate + below); };
  auto face = static_cast<std::size_t>(profile.edge / profile.bin);
  while (face < profile.height.size() && !isBelow(face)) ++face;
  const double from = middle(profile, face) + std::max(kBeside, profile.blur) - 0.5 * profile.bin;
  for (std::size_t i = face; i < profile.height.size(); ++i) {
    const double d = middle(profile, i);
    if (isBelow(i) && d >= from && d < from + 2.0 * profile.bin) beside.push_back(level(i) - below);
  }
  return beside.empty() ? 0.0 : std::max(0.0, median(beside) - 2.0 * robustSigma(far, below));
}

double liftOf(double seen, double lip, double lean) {
  constexpr double kLift = 0.3;  // of the lean: what falls off with the square of the distance, in the lip's middle
  return lean > 0.0 && std::isfinite(seen) && std::isfinite(lip) ? kLift * std::abs(seen - lip) : 0.0;
}

}  // namespace tank_datum
