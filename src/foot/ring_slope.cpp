#include "foot/ring_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.h"
#include "core/statistics.h"

namespace tank_datum {
namespace {

constexpr double kTankSlope = 0.03;  // of the lips of one tank, on the average of its ring [m/m]

double withPrior(double sigma) { return 1.0 / std::hypot(1.0 / sigma, 1.0 / kTankSlope); }

double density(double off, double sigma) { return portable::exp(-0.5 * off * off / (sigma * sigma)) / sigma; }

/// The ring's own slope for what its windows show: of two kinds of tanks, those whose lips are parallel to what they
/// lie on and those whose lips lean as they like, as many of each, as likely as what is seen is of either. Of a slope
/// that beams may feign, lips that lean have half.
/// @param error  standard error of what the windows show
MeanSlope ringSlope(double seen, double error, const ExpectedSlope& expected) {
  constexpr double kBeams = 0.6;  // standard deviation of what beams feign, of the most
  const double off = seen - expected.parallel, doubt = std::hypot(expected.noise, error);
  if (std::abs(off) > kSteepestLip + expected.lean) return {seen, expected.parallel, kLipSlope};
  const double feigned = std::clamp(-off, 0.0, expected.lean), beams = kBeams * expected.lean;
  const double odd = std::hypot(doubt, beams), own = off + 0.5 * feigned;
  const double parallel = density((off + feigned) / doubt, 1.0) / odd,
               leaning = density(own, std::hypot(odd, kTankSlope));
  const double share = leaning / (parallel + leaning);
  const double weight = kTankSlope * kTankSlope / (kTankSlope * kTankSlope + odd * odd), mean = weight * own;
  const double variance = (1.0 - share) * beams * beams + share * (weight * odd * odd + (1.0 - share) * mean * mean);
  return {seen, expected.parallel + share * mean, withPrior(std::hypot(std::sqrt(variance), kBeams * expected.more))};
}

/// Slopes that are known, and the variances of their errors.
struct KnownSlopes {
  std::vector<double> values, variances;

  /// Those with a standard error no larger than that.
  KnownSlopes(const std::vector<SeriesValue>& series, double largest) {
    for (const SeriesValue& v : series) {
      if (!std::isfinite(v.value) || v.sigma > largest) continue;
      values.push_back(v.value);
      variances.push_back(v.sigma * v.sigma);
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

}  // namespace

MeanSlope drawTogether(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series,
                       const ExpectedSlope& expected, std::vector<SeriesValue>& smooth) {
  constexpr double kBest = 0.1;  // of the windows: those seen best tell the ring's own slope
  constexpr std::size_t kFewest = 6;
  std::vector<double> sigmas;
  for (const SeriesValue& v : series) {
    if (std::isfinite(v.value)) sigmas.push_back(v.sigma);
  }
  const KnownSlopes best(series, 2.0 * quantile(sigmas, kBest));
  MeanSlope ring{expected.parallel, expected.parallel, withPrior(kLipSlope)};
  double own = kLipSlope * kLipSlope;
  if (best.values.size() >= kFewest) {
    const KnownSlopes all(seen, std::numeric_limits<double>::infinity());
    own = std::clamp(std::min(best.amongThem(), all.amongThem()), 1e-12, own);
    const auto count = static_cast<double>(best.values.size());
    const double mean = kMedianOverMean * std::sqrt((own + median(best.variances)) / count);
    ring = ringSlope(median(best.values), mean, expected);
    ring.sigma_seen = mean;
  }
  for (SeriesValue& v : smooth) {
    if (!std::isfinite(v.value)) continue;
    const double weight = own / (own + v.sigma * v.sigma);
    v.value = weight * (v.value + ring.slope - ring.seen) + (1.0 - weight) * ring.slope;
    v.sigma *= std::sqrt(weight);
  }
  return ring;
}

}  // namespace tank_datum
