#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/foot_fit.h"
#include "foot/foot_state.h"

namespace tank_datum {

FootFit fitStation(const Foot& foot, std::size_t station, double level, const FootProfile& profile,
                   const FootPriors& priors) {
  constexpr double kWidestAngle = 10.0 * kPi / 180.0;  // of a curve that a parabola still follows
  constexpr double kKnownSlope = 0.003;                // [m/m]
  constexpr double kGoodEnough = 2e-4;                 // to find the surface with [m]
  constexpr std::size_t kEnough = 8;                   // points; with fewer a window may be wider than asked for
  constexpr double kWidestSparse = 5.0 * kPi / 180.0;
  const FootPrior prior = priors.at(station);
  const double slope = priors.slope[station], start = level + profile.offset;
  const double widest = std::min(foot.options.widest_window / foot.radius, kWidestAngle);
  FootPrior known_slope = prior;
  known_slope.sigma_slope = priors.settled ? kSettledSlope : std::min(prior.sigma_slope, kKnownSlope);
  for (double half = foot.half_step;; half *= 1.4) {
    const auto points = foot.ring.around(foot.directions[station], half, level, foot.reach);
    FootFit fit = fitFoundation(points, profile, start, slope, known_slope);
    const bool wide = half > widest && (fit.points >= kEnough || half > kWidestSparse);
    if (fit.sigma < std::max(kGoodEnough, foot.options.wanted_sigma) || wide) {
      if (priors.settled) {
        fit.sigma = std::hypot(fit.sigma, fit.middle * prior.sigma_slope);
      } else {
        fit = fitFoundation(points, profile, start, slope, prior);
      }
      fit.half_width = half;
      return fit;
    }
  }
}

}  // namespace tank_datum
