#include "fit/two_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kLeastShare = 1e-6;  // of all, below which a deviation is none

/// Weighted mean and standard deviation of values.
struct Spread {
  double weight = 0, sum = 0, squares = 0;

  void add(double w, double value) {
    weight += w;
    sum += w * value;
    squares += w * value * value;
  }
  double mean() const { return sum / weight; }
  double deviation() const { return std::sqrt(std::max(0.0, squares / weight - mean() * mean())); }
};

/// Of one level with the values' own deviation, but for a constant.
double logLikelihoodOfOne(const std::vector<double>& values) {
  Spread all;
  for (const double v : values) all.add(1.0, v - values.front());
  return -all.weight * portable::log(all.deviation()) - 0.5 * all.weight;
}

/// Sums of the values weighted by how likely they belong to the lower level.
struct Split {
  double weight = 0, low = 0, high = 0, log_likelihood = 0;
};

/// How the model divides the values between its levels, and how likely it makes them but for a constant.
Split divide(const TwoLevels& model, const std::vector<double>& values) {
  Split split;
  for (const double v : values) {
    const double a = (v - model.low) / model.sigma, b = (v - model.high) / model.sigma;
    // relative to the larger of the two densities, so that neither is lost far out
    const double least = std::min(a * a, b * b), lesser = portable::exp(-0.5 * std::abs(a * a - b * b));
    const double low = model.share * (a * a > least ? lesser : 1.0);
    const double high = (1.0 - model.share) * (b * b > least ? lesser : 1.0);
    const double weight = low / (low + high);
    split.weight += weight;
    split.low += weight * v;
    split.high += (1.0 - weight) * v;
    split.log_likelihood += portable::log(low + high) - 0.5 * least;
  }
  split.log_likelihood -= static_cast<double>(values.size()) * portable::log(model.sigma);
  return split;
}

/// One step of the EM algorithm.
TwoLevels improved(const Split& split, double squares, double count) {
  TwoLevels next;
  next.share = split.weight / count;
  next.low = split.low / split.weight;
  next.high = split.high / (count - split.weight);
  const double explained = split.weight * next.low * next.low + (count - split.weight) * next.high * next.high;
  next.sigma = std::sqrt((squares - explained) / count);
  return next;
}

}  // namespace

bool TwoLevels::isHigh(double value) const {
  const double middle = 0.5 * (low + high), shift = sigma * sigma / apart() * portable::log(share / (1.0 - share));
  return value > middle + shift;
}

TwoLevels fitTwoLevels(const std::vector<double>& values) {
  constexpr int kSteps = 40;
  const auto count = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double v : values) mean += v / count;
  for (const double v : values) squares += (v - mean) * (v - mean);
  std::vector<double> centred;
  for (const double v : values) centred.push_back(v - mean);
  const double alone = std::sqrt(squares / count), single = logLikelihoodOfOne(values);
  TwoLevels best;
  best.sigma = alone;
  for (const double share : {0.2, 0.5, 0.8}) {
    TwoLevels model{share, quantile(centred, 0.5 * share), quantile(centred, 0.5 + 0.5 * share), 0.5 * alone, 0.0};
    Split split = divide(model, centred);
    for (int step = 0; step < kSteps && split.weight > 1.0 && count - split.weight > 1.0; ++step) {
      model = improved(split, squares, count);
      if (!(model.sigma > kLeastShare * alone)) break;
      split = divide(model, centred);
    }
    model.gain = split.log_likelihood - single;
    if (model.gain > best.gain) best = model;
  }
  best.low += mean;
  best.high += mean;
  return best;
}

double gainOfStrays(const std::vector<double>& values) {
  constexpr int kSteps = 40;
  const auto count = static_cast<double>(values.size());
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double stray = std::sqrt(kTwoPi) / (*largest - *least);  // density, in the normal distribution's units
  double level = median(values), sigma = robustSigma(values, level), share = 0.9, log_likelihood = 0.0;
  for (int step = 0; step < kSteps && share > 0.0; ++step) {
    Spread of_level;
    log_likelihood = 0.0;
    for (const double v : values) {
      const double off = (v - level) / sigma, normal = share * portable::exp(-0.5 * off * off) / sigma;
      const double either = normal + (1.0 - share) * stray;
      of_level.add(normal / either, v - level);
      log_likelihood += portable::log(either);
    }
    level += of_level.mean();
    sigma = std::max(of_level.deviation(), kLeastShare * (*largest - *least));
    share = of_level.weight / count;
  }
  return log_likelihood - logLikelihoodOfOne(values);
}

}  // namespace tank_datum
