#include "fit/ring_process.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "fit/ring_filter.h"
#include "fit/ring_scatter.h"

namespace tank_datum {
namespace {

constexpr std::array kAmplitudes{1.0, 2.0, 4.0, 8.0, 16.0};  // of the least
constexpr std::array kLengths{3.0, 5.0, 8.0, 12.0, 18.0};    // [deg]; longer ones would not follow a short dip

/// @param scatter  usual standard error of the values
/// @param ratio  how many of their standard errors values scatter by at least
ProcessParameters likeliest(const RingData& data, double scatter, double ratio, double least_amplitude) {
  constexpr double kLeastScale = 0.4;
  struct Scatter {
    double scale, nugget;
  };
  constexpr std::array kScatters{Scatter{0.5, 0.0}, Scatter{0.6, 0.0}, Scatter{0.8, 0.0}, Scatter{1.0, 0.0},
                                 Scatter{1.0, 0.4}, Scatter{1.0, 0.7}, Scatter{1.0, 1.0}, Scatter{1.0, 1.5},
                                 Scatter{1.0, 2.5}, Scatter{1.0, 4.0}};
  std::vector<Scatter> scatters{{std::clamp(ratio, kLeastScale, 1.0), std::sqrt(std::max(0.0, ratio * ratio - 1.0))}};
  std::copy_if(kScatters.begin(), kScatters.end(), std::back_inserter(scatters),
               [&](const Scatter& s) { return std::hypot(s.scale, s.nugget) > ratio; });
  ProcessParameters best{};
  double least = std::numeric_limits<double>::infinity();
  for (const double amplitude : kAmplitudes) {
    for (const double length : kLengths) {
      for (const Scatter& s : scatters) {
        const ProcessParameters p{amplitude * least_amplitude, length * kPi / 180.0, s.scale, s.nugget * scatter};
        const double unlikely = unlikeliness(data, p);
        if (unlikely < least) least = unlikely, best = p;
      }
    }
  }
  return best;
}

/// How far each value lies off what the others say, in standard deviations with its sign.
std::vector<double> offOthers(const RingData& data, const ProcessParameters& p, const RingProcess& result,
                              std::vector<double>& offs) {
  std::vector<double> ratios(data.values.size(), 0.0);
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    if (!std::isfinite(data.values[i])) continue;
    const double own = p.variance(data.variances[i]), all = result.sigma[i] * result.sigma[i];
    const double others = 1.0 / std::max(1.0 / all - 1.0 / own, 1e-9 / own);
    offs[i] = data.values[i] - others * (result.value[i] / all - data.values[i] / own);
    ratios[i] = offs[i] / std::sqrt(others + own);
  }
  return ratios;
}

/// What is far off counts for what it is off, unless a neighbour is off the same way: that is a dip.
void doubtStrays(RingData& data, const ProcessParameters& p, RingProcess& result) {
  constexpr double kFar = 4.0, kAlso = 1.5;
  const std::size_t count = data.values.size();
  std::vector<double> offs(count, 0.0);
  const std::vector<double> ratios = offOthers(data, p, result, offs);
  const auto next = [&](std::size_t i, std::size_t step) {
    std::size_t j = (i + step) % count;
    while (j != i && !std::isfinite(data.values[j])) j = (j + step) % count;
    return j;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(ratios[i]) <= kFar) continue;
    const auto follows = [&](std::size_t j) { return std::abs(ratios[j]) > kAlso && ratios[j] * ratios[i] > 0.0; };
    const std::size_t after = next(i, 1), before = next(i, count - 1);
    if (follows(after) || follows(before)) continue;
    result.doubt[i] = std::max(result.doubt[i], std::abs(ratios[i]));
    data.variances[i] += offs[i] * offs[i] / (p.scale * p.scale);
    for (std::size_t j = (before + 1) % count; j != after; j = (j + 1) % count)
      result.strayed[j] = std::max(result.strayed[j], std::abs(offs[i]));
  }
}

/// How likely each value is by what the others say, as a logarithm; 0 where there is none.
std::vector<double> likelihoods(const RingData& data, const ProcessParameters& p, const RingProcess& result) {
  std::vector<double> offs(data.values.size(), 0.0), logs(data.values.size(), 0.0);
  const std::vector<double> ratios = offOthers(data, p, result, offs);
  for (std::size_t i = 0; i < offs.size(); ++i) {
    if (!std::isfinite(data.values[i]) || ratios[i] == 0.0) continue;
    logs[i] = -0.5 * square(ratios[i]) - std::log(std::abs(offs[i] / ratios[i]));
  }
  return logs;
}

/// Where quicker processes foretell the values better than the one that is likeliest of the whole ring, the ring bends
/// as it does nowhere else: there each counts by how likely the values near by are under it.
void followBends(const RingData& data, const ProcessParameters& p, double least_amplitude, RingProcess& result) {
  const double kRarely = getenv("BO") ? atof(getenv("BO")) : 4.0;  // odds against a bend at any place, as a logarithm
  const double kW = getenv("BW") ? atof(getenv("BW")) : 5.0; 
  if (kRarely > 99) return;
  const auto quickness = [](const ProcessParameters& q) { return square(q.amplitude) / (q.length * q.length * q.length); };
  std::vector<RingProcess> all{result};
  std::vector<std::vector<double>> logs{likelihoods(data, p, result)};
  for (const double amplitude : kAmplitudes) {
    for (const double length : kLengths) {
      const ProcessParameters q{amplitude * least_amplitude, length * kPi / 180.0, p.scale, p.nugget};
      if (quickness(q) <= quickness(p)) continue;
      all.push_back(result);
      smoothRing(data, q, all.back());
      logs.push_back(likelihoods(data, q, all.back()));
    }
  }
  const std::size_t count = data.values.size();
  const auto reach = static_cast<std::size_t>(kW * kPi / 180.0 / data.step);
  const double rare = kRarely + std::log(double(all.size()));
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> likely(all.size(), -rare);
    likely[0] = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (std::size_t j = i + count - reach; j <= i + count + reach; ++j) likely[k] += logs[k][j % count];
    }
    const double best = *std::max_element(likely.begin(), likely.end());
    double sum = 0.0, mean = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double share = std::exp(likely[k] - best), off = all[k].value[i] - all[0].value[i];
      sum += share;
      mean += share * off;
      squares += share * (square(all[k].sigma[i]) + square(off));
    }
    mean /= sum;
    if (getenv("DBGB") && std::exp(likely[0]-best)/sum<.95) fprintf(stderr, "BENT %zu share %.2f better %.1f by %.2f\n", i, 1-std::exp(likely[0]-best)/sum, best-likely[0], 1e3*mean);
    result.value[i] = all[0].value[i] + mean;
    result.sigma[i] = std::sqrt(squares / sum - square(mean));
  }
}

}  // namespace

bool RingProcess::holds(double at_place, double its_sigma, std::size_t place) const {
  constexpr double kFar = 3.0;
  return std::abs(at_place - value[place]) <= kFar * std::hypot(its_sigma, sigma[place]);
}

double RingProcess::sigmaOfFollowed(std::size_t place) const {
  const double added = kEither * strayed[place];
  return std::sqrt(std::max(0.0, square(sigmaIfShaped(place)) - square(added)));
}

double RingProcess::sigmaIfShaped(std::size_t place) const {
  const double waves = shape.empty() ? 0.0 : shape[place];
  return std::sqrt(std::max(0.0, square(sigma[place]) - square(waves)));
}

RingProcess followRing(const std::vector<double>& values, const std::vector<double>& sigmas, double least_amplitude) {
  constexpr int kOrder = 4;
  constexpr std::size_t kFewestValues = 8;
  constexpr double kChance = 2.6;  // over the root of their number: two standard deviations of such a scatter
  RingProcess result;
  std::vector<double> azimuths, known, weights, errors;
  const double step = kTwoPi / static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    azimuths.push_back(static_cast<double>(i) * step);
    known.push_back(values[i]);
    errors.push_back(sigmas[i]);
  }
  if (known.size() < kFewestValues) return result;
  const double usual = std::max(median(errors), 1e-9);
  for (const double error : errors) weights.push_back(1.0 / (1.0 + error * error / (usual * usual)));
  const PeriodicFit shape = fitHarmonics(azimuths, known, weights, {kOrder, true, 1e-4});
  RingData data{values, {}, step};
  for (std::size_t i = 0; i < values.size(); ++i) {
    data.values[i] -= shape(static_cast<double>(i) * step);
    data.variances.push_back(sigmas[i] * sigmas[i]);
  }
  const double beyond_chance = 1.0 + kChance / std::sqrt(static_cast<double>(known.size()));
  const double scatter = ringScatter(data.values, sigmas);
  const double ratio = scatter > 0.0 ? scatter / beyond_chance : 1.0;  // errors that cannot be judged stand as given
  const ProcessParameters p = likeliest(data, usual, ratio, least_amplitude);
  result.amplitude = p.amplitude, result.length = p.length, result.nugget = p.nugget, result.scale = p.scale;
  result.value.resize(values.size());
  result.sigma.resize(values.size());
  result.doubt.assign(values.size(), 0.0);
  result.strayed.assign(values.size(), 0.0);
  for (int iteration = 0; iteration < 2; ++iteration) {
    smoothRing(data, p, result);
    doubtStrays(data, p, result);
  }
  smoothRing(data, p, result);
  followBends(data, p, least_amplitude, result);
  for (const double variance : varianceOfShape(data, p, kOrder)) result.shape.push_back(std::sqrt(variance));
  for (std::size_t i = 0; i < values.size(); ++i)
    result.sigma[i] = std::hypot(std::hypot(result.sigma[i], result.shape[i]), kEither * result.strayed[i]);
  for (std::size_t i = 0; i < values.size(); ++i) result.value[i] += shape(static_cast<double>(i) * step);
  return result;
}

}  // namespace tank_datum
