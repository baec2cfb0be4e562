#include "foot/ring_slope.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace tank_datum {
namespace {

constexpr double kTankSlope = 0.03;  // of the lips of one tank, on the average of its ring [m/m]

double withPrior(double sigma) { return 1.0 / std::hypot(1.0 / sigma, 1.0 / kTankSlope); }

/// The ring's own slope for what its windows show. Where that is neither of those expected, beams may feign it, half as
/// much as they can and no more than makes the lip parallel; and lips are parallel but for what a tank's usually lean.
/// @param error  standard error of what the windows show
MeanSlope ringSlope(double seen, double error, const ExpectedSlope& expected) {
  constexpr double kDoubt = 0.35;  // of what may feign a slope or hide one, where it seems to be as expected
  constexpr double kOddDoubt = 0.6;
  const double off = seen - expected.parallel, doubt = std::hypot(expected.noise, error);
  const double beams = kOddDoubt * expected.lean, feigned = std::clamp(-off, 0.0, expected.lean);
  const double usual = withPrior(std::hypot(kDoubt * doubt, beams));
  if (off < doubt && off > -doubt - expected.lean) return {seen, expected.parallel, usual};
  if (expected.lean <= 0.0 && std::abs(seen - expected.section) < doubt) return {seen, expected.section, usual};
  if (std::abs(off) > kSteepestLip + expected.lean) return {seen, expected.parallel, kLipSlope};
  const double odd = std::hypot(doubt, beams);
  const double weight = kTankSlope * kTankSlope / (kTankSlope * kTankSlope + odd * odd);
  return {seen, expected.parallel + weight * (off + 0.5 * feigned), withPrior(odd)};
}

}  // namespace

MeanSlope drawTogether(const std::vector<SeriesValue>& series, const ExpectedSlope& expected,
                       std::vector<SeriesValue>& smooth) {
  constexpr double kBest = 0.1;  // of the windows: those seen best tell the ring's own slope
  constexpr std::size_t kFewest = 6;
  constexpr double kDoubted = 0.5;  // of the standard error of their variance: so much they may differ unseen
  std::vector<double> values, variances, sigmas;
  for (const SeriesValue& v : series) {
    if (std::isfinite(v.value)) sigmas.push_back(v.sigma);
  }
  const double trusted = 2.0 * quantile(sigmas, kBest);
  for (const SeriesValue& v : series) {
    if (!std::isfinite(v.value) || v.sigma > trusted) continue;
    values.push_back(v.value);
    variances.push_back(v.sigma * v.sigma);
  }
  MeanSlope ring{expected.parallel, expected.parallel, withPrior(kLipSlope)};
  double own = kLipSlope * kLipSlope;
  if (values.size() >= kFewest) {
    const double seen = median(values), scatter = robustSigma(values, seen);
    const auto count = static_cast<double>(values.size());
    const double square = scatter * scatter, doubt = kDoubted * square * std::sqrt(2.0 / count);
    own = std::clamp(std::max(doubt, square - median(variances)), 1e-12, own);
    const double mean = 1.2533 * std::sqrt((own + median(variances)) / count);
    ring = ringSlope(seen, mean, expected);
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
