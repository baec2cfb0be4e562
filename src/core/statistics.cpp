#include "core/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/normal95.h"
#include "core/portable_math.h"

namespace tank_datum {

std::vector<double> finiteOf(const std::vector<double>& values) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) { return std::isfinite(v); });
  return finite;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double weightedMedian(std::vector<WeightedValue> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end(),
            [](const WeightedValue& a, const WeightedValue& b) { return a.value < b.value; });
  double half = 0.0;
  for (const WeightedValue& v : values) half += 0.5 * v.weight;
  std::size_t k = 0;
  double reached = values[0].weight;
  while (k + 1 < values.size() && reached < half) reached += values[++k].weight;
  return k + 1 < values.size() && reached <= half ? 0.5 * (values[k].value + values[k + 1].value) : values[k].value;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double rank = std::floor(q * static_cast<double>(values.size()));
  const auto last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  const auto at = values.begin() + std::min(last, static_cast<std::ptrdiff_t>(rank));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double robustSigma(const std::vector<double>& values, double center) {
  std::vector<double> deviations(values.size());
  std::transform(values.begin(), values.end(), deviations.begin(), [&](double v) { return std::abs(v - center); });
  return 1.4826 * median(std::move(deviations));
}

double biweightSigma(const std::vector<double>& values) {
  constexpr double kReach = 9.0;  // median absolute deviations
  const double middle = median(values), reach = kReach / 1.4826 * robustSigma(values, middle);
  if (!(reach > 0.0)) return reach;
  double above = 0.0, below = 0.0;
  for (const double value : values) {
    const double off = value - middle, u2 = square(off / reach);
    if (u2 >= 1.0) continue;
    above += off * off * square(square(1.0 - u2));
    below += (1.0 - u2) * (1.0 - 5.0 * u2);
  }
  return std::sqrt(static_cast<double>(values.size()) * above) / std::abs(below);
}

double halfSampleMode(const std::vector<double>& sorted) {
  std::size_t first = 0, count = sorted.size();
  while (count > 3) {
    const std::size_t half = (count + 1) / 2;
    std::size_t best = first;
    for (std::size_t i = first; i + half <= first + count; ++i) {
      if (sorted[i + half - 1] - sorted[i] < sorted[best + half - 1] - sorted[best]) best = i;
    }
    first = best;
    count = half;
  }
  return sorted[first + count / 2];
}

double tukeyWeight(double residual_in_sigmas) {
  const double u = residual_in_sigmas / 4.685;
  if (std::abs(u) >= 1.0) return 0.0;
  const double w = 1.0 - u * u;
  return w * w;
}

double student95(double freedom) {
  constexpr double kOne = 12.706204736432095, kTwo = 4.302652729911275;
  if (freedom > 0.0 && freedom <= 1.0) return kOne;
  if (freedom > 0.0 && freedom <= 2.0) return kTwo;
  return studentQuantile(freedom, kNormal95);
}

double studentQuantile(double freedom, double deviate) {
  const double z = deviate;
  if (!(freedom > 0.0)) return z;
  const double z2 = z * z, n = freedom;
  const double first = z * (z2 + 1.0) / 4.0;
  const double second = z * ((5.0 * z2 + 16.0) * z2 + 3.0) / 96.0;
  const double third = z * (((3.0 * z2 + 19.0) * z2 + 17.0) * z2 - 15.0) / 384.0;
  const double fourth = z * ((((79.0 * z2 + 776.0) * z2 + 1482.0) * z2 - 1920.0) * z2 - 945.0) / 92160.0;
  return z + (first + (second + (third + fourth / n) / n) / n) / n;
}

double chiSquareQuantile(double freedom, double deviate) {
  const double part = 2.0 / (9.0 * freedom);
  return freedom * portable::pow(1.0 - part + deviate * std::sqrt(part), 3.0);
}

double fQuantile(double first, double second, double deviate) {
  const double u = 2.0 / (9.0 * first), v = 2.0 / (9.0 * second), square = deviate * deviate;
  // the cube root x of F is where (1 - v) x - (1 - u) is deviate standard deviations, sqrt(v x^2 + u)
  const double a = (1.0 - v) * (1.0 - v) - square * v, b = (1.0 - v) * (1.0 - u);
  const double c = (1.0 - u) * (1.0 - u) - square * u;
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return portable::pow((b + (deviate < 0.0 ? -root : root)) / a, 3.0);
}

}  // namespace tank_datum
