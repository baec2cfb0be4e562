#include <algorithm>
#include <cmath>
#include <limits>

#include "core/units.h"
#include "foot/foot_fit.h"
#include "foot/foot_state.h"

namespace tank_datum {
namespace {

/// What windows of growing width say of a level: the part that their intervals share. A window that leaves it is wider
/// than its parabola can follow (intersection of confidence intervals, Goldenshluger and Nemirovski 1997).
class Agreement {
 public:
  bool holds(const FootFit& fit) const {
    const double apart = kApart * fit.sigmaOfPoints();
    return fit.z - apart <= high_ && fit.z + apart >= low_;
  }

  void add(const FootFit& fit) {
    if (!fit.valid()) return;
    low_ = std::max(low_, fit.z - kApart * fit.sigmaOfPoints());
    high_ = std::min(high_, fit.z + kApart * fit.sigmaOfPoints());
  }

 private:
  static constexpr double kApart = 2.5;  // standard errors
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
};

}  // namespace

FootFit fitStation(const Foot& foot, std::size_t station, double level, const FootProfile& profile,
                   const FootPriors& priors) {
  constexpr double kWidestAngle = 10.0 * kPi / 180.0;  // of a curve that a parabola still follows
  constexpr double kKnownSlope = 0.003;                // [m/m]
  constexpr double kGoodEnough = 2e-4;                 // to find the surface with [m]
  constexpr std::size_t kEnough = 8;                   // points; with fewer a window may be wider than asked for
  constexpr double kWidestSparse = 5.0 * kPi / 180.0;
  const FootPrior prior = priors.at(station);
  const double start = level + profile.offset;
  const double widest = std::min(foot.options.widest_window / foot.radius, kWidestAngle);
  FootPrior known_slope = prior;
  known_slope.sigma_slope = priors.settled ? kSettledSlope : std::min(prior.sigma_slope, kKnownSlope);
  const auto pointsWithin = [&](double half) {
    return foot.ring.around(foot.directions[station], half, level, foot.reach);
  };
  FootFit fit;
  Agreement agreement;
  const bool told = isResolved(foot);  // errors of cameras are alike for neighbours: narrow windows seem too sure
  for (double half = foot.half_step;; half *= 1.4) {
    FootFit wider = fitFoundation(pointsWithin(half), profile, start, known_slope);
    if (told && fit.valid() && !agreement.holds(wider)) break;  // the surface is no parabola over so long an arc
    wider.half_width = half;
    fit = wider;
    agreement.add(fit);
    const bool wide = half > widest && (fit.points >= kEnough || half > kWidestSparse);
    if (fit.sigmaOfPoints() < std::max(kGoodEnough, foot.options.wanted_sigma) || wide) break;
  }
  if (priors.settled) {
    fit.sigma = std::hypot(fit.sigma, fit.middle * prior.sigma_slope);
    return fit;
  }
  FootFit free = fitFoundation(pointsWithin(fit.half_width), profile, start, prior);
  free.half_width = fit.half_width;
  return free;
}

}  // namespace tank_datum
