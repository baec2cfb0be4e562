#include "foot/ring_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle_process.h"

namespace tank_datum {
namespace {

constexpr double kTankSlope = 0.03;   // of the lips of one tank, on the average of its ring [m/m]
constexpr double kRoundRing = 0.015;  // of lips about their ring's average, along which it may change [m/m]

double withPrior(double sigma) { return 1.0 / std::hypot(1.0 / sigma, 1.0 / kTankSlope); }

double density(double off, double sigma) { return portable::exp(-0.5 * off * off / (sigma * sigma)) / sigma; }

/// Root mean square of what beams draw a lip down by that is seen to lean up, by that much against what it lies on: of
/// a normal distribution cut off at 0.
/// @param beams  standard deviation of what they feign, before it is seen
double drawnDown(double off, double beams) {
  constexpr double kFarOut = 20.0;  // standard deviations: an exponential distribution from there on
  const double width = 1.0 / std::hypot(1.0 / beams, 1.0 / kTankSlope), middle = -off * square(width / kTankSlope);
  const double from = -middle / width;
  if (from > kFarOut) return std::sqrt(2.0) * width / from;
  const double hazard =
      std::sqrt(2.0 / kPi) * portable::exp(-0.5 * from * from) / portable::erfc(from / std::sqrt(2.0));
  return std::sqrt(square(width) + middle * (middle + width * hazard));
}

/// The ring's own slope for what its windows show: of two kinds of tanks, those whose lips are parallel to what they
/// lie on and those whose lips lean as they like, as many of each, as likely as what is seen is of either. Of a slope
/// that beams may feign, lips that lean have half; one that leans up no beam has feigned, it leans no less.
/// @param error  standard error of what the windows show
MeanSlope ringSlope(double seen, double error, const ExpectedSlope& expected) {
  constexpr double kBeams = 0.6;  // standard deviation of what beams feign, of the most
  const double off = seen - expected.parallel, doubt = std::hypot(expected.noise, error);
  if (std::abs(off) > kSteepestLip + expected.lean) return {seen, expected.parallel, kLipSlope};
  const double feigned = std::clamp(-off, 0.0, expected.lean), beams = kBeams * expected.lean;
  const double odd = std::hypot(doubt, beams), own = off + 0.5 * feigned, known = off > 0.0 ? doubt : odd;
  const double unsure = expected.sigma_parallel, told = square(unsure) / (square(unsure) + square(known));
  const double parallel = density((off + feigned) / std::hypot(doubt, unsure), 1.0) / std::hypot(odd, unsure),
               leaning = density(own, std::hypot(odd, kTankSlope));
  const double share = leaning / (parallel + leaning);
  const double weight = kTankSlope * kTankSlope / (kTankSlope * kTankSlope + known * known), mean = weight * own;
  const double near = told * own;
  const double steeper = off > 0.0 && beams > 0.0 ? square(drawnDown(off, beams)) : 0.0;
  const double variance = (1.0 - share) * (beams * beams + told * known * known + share * square(mean - near)) +
                          share * (weight * known * known + steeper);
  return {seen, expected.parallel + share * mean + (1.0 - share) * near,
          withPrior(std::hypot(std::sqrt(variance), kBeams * expected.more))};
}

/// Slopes that are known, and the variances of the errors of what is seen.
struct KnownSlopes {
  std::vector<double> values, variances;

  /// Those with a standard error no larger than that, what beams may feign in it.
  KnownSlopes(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series, double largest) {
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!std::isfinite(seen[k].value) || series[k].sigma > largest) continue;
      values.push_back(seen[k].value);
      variances.push_back(square(seen[k].sigma));
    }
  }

  /// Variance beyond that of their errors; so much as they may differ unseen at least.
  double amongThem() const {
    constexpr double kDoubted = 0.5;  // of the standard error of their variance
    const double scatter = robustSigma(values, median(values)), square = scatter * scatter;
    return std::max(kDoubted * square * std::sqrt(2.0 / static_cast<double>(values.size())),
                    square - median(variances));
  }
};

/// What windows err by and what beams may feign in each: of the latter windows have half alike, and half each its own.
struct WindowErrors {
  std::vector<double> own, feigned;  ///< variances

  WindowErrors(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series, double common) {
    for (std::size_t k = 0; k < seen.size(); ++k) {
      own.push_back(square(seen[k].sigma) - square(common));
      feigned.push_back(std::max(0.0, square(series[k].sigma) - square(seen[k].sigma)));
    }
  }
};

/// Where windows lie above what follows them, those to either side taken together: by more than chance explains.
std::vector<bool> liesAbove(const std::vector<NoisyValue>& off, const std::vector<ProcessValue>& followed,
                            const std::vector<SeriesValue>& seen) {
  constexpr std::size_t kBeside = 2;
  constexpr double kChance = 3.0;  // standard errors
  const std::size_t count = off.size();
  std::vector<bool> above(count, false);
  for (std::size_t k = 0; k < count; ++k) {
    double weights = 0.0, sum = 0.0;
    for (std::size_t j = k + count - kBeside; j <= k + count + kBeside; ++j) {
      const std::size_t i = j % count;
      if (!std::isfinite(off[i].value)) continue;
      const double weight = 1.0 / square(seen[i].sigma);
      weights += weight, sum += weight * (off[i].value - followed[i].value);
    }
    above[k] = std::isfinite(off[k].value) && off[k].value > followed[k].value && sum > kChance * std::sqrt(weights);
  }
  return above;
}

/// How far the windows lie off the ring's slope, as a process that follows them says. Beams only draw a slope down:
/// where it follows windows to well below what they show, they feign nothing there.
/// @param rises  whether what lies beyond the lips lies higher: beams draw slopes up there
std::vector<SeriesValue> offRing(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series,
                                 double common, double ring, bool rises) {
  WindowErrors errors(seen, series, common);
  std::vector<ProcessValue> followed;
  for (bool changed = true; changed;) {
    std::vector<NoisyValue> off;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double away = seen[k].value - ring, half = 0.5 * errors.feigned[k];
      const double strange = std::abs(away) > kSteepestLip ? square(away) : 0.0;  // farther off than any lip
      off.push_back({away, std::sqrt(errors.own[k] + half + strange), std::sqrt(half)});
    }
    followed = followCircle(off, common, kRoundRing);
    changed = false;
    const std::vector<bool> above = rises ? std::vector<bool>(seen.size(), false) : liesAbove(off, followed, seen);
    for (std::size_t k = 0; k < seen.size(); ++k) {
      if (!above[k] || errors.feigned[k] == 0.0) continue;
      errors.feigned[k] = 0.0;
      changed = true;
    }
  }
  std::vector<SeriesValue> windows = seen;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (std::isfinite(seen[k].value)) windows[k] = {followed[k].value, followed[k].sigma, 1.0};
  }
  return windows;
}

/// The same of few windows, each by itself.
std::vector<SeriesValue> eachOffRing(std::vector<SeriesValue> windows, double ring) {
  for (SeriesValue& v : windows) {
    const double weight = square(kLipSlope) / (square(kLipSlope) + square(v.sigma));
    v = {weight * (v.value - ring), std::sqrt(weight) * v.sigma, 1.0};
  }
  return windows;
}

}  // namespace

RingSlopes drawTogether(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series, double common,
                        const ExpectedSlope& expected) {
  constexpr double kBest = 0.1;  // of the windows: those seen best tell the ring's own slope
  constexpr std::size_t kFewest = 6;
  std::vector<double> sigmas;
  for (const SeriesValue& v : series) {
    if (std::isfinite(v.value)) sigmas.push_back(v.sigma);
  }
  const KnownSlopes best(seen, series, 2.0 * quantile(sigmas, kBest));
  RingSlopes slopes{{expected.parallel, expected.parallel, withPrior(kLipSlope)}, {}};
  if (best.values.size() < kFewest) {
    slopes.windows = eachOffRing(series, expected.parallel);
  } else {
    const KnownSlopes all(seen, series, std::numeric_limits<double>::infinity());
    const double own = std::clamp(std::min(best.amongThem(), all.amongThem()), 1e-12, square(kLipSlope));
    const auto count = static_cast<double>(best.values.size());
    const double mean = kMedianOverMean * std::sqrt((own + median(best.variances)) / count);
    slopes.ring = ringSlope(median(best.values), mean, expected);
    slopes.ring.sigma_seen = mean;
    slopes.windows = offRing(seen, series, common, slopes.ring.seen, expected.more > 0.0);
  }
  for (SeriesValue& v : slopes.windows) v.value += slopes.ring.slope;
  return slopes;
}

}  // namespace tank_datum
