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
#include "fit/ring_bends.h"
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
        const ProcessParameters p{amplitude * least_amplitude, toRadians(length), s.scale, s.nugget * scatter};
        const double unlikely = unlikeliness(data, p);
        if (unlikely < least) least = unlikely, best = p;
      }
    }
  }
  return best;
}

/// What a ring may be at any place: processes that change more quickly along it, of the same scatter; and the same
/// process with values that scatter more, which may look like a quicker one.
std::vector<ProcessParameters> alternativesTo(const ProcessParameters& p, double least_amplitude) {
  constexpr std::array kCoarser{2.0, 4.0};
  // short changes of a Matern process of order 3/2 have a variance of its own over the cube of its length
  const auto quickness = [](const ProcessParameters& q) {
    return square(q.amplitude) / (q.length * q.length * q.length);
  };
  std::vector<ProcessParameters> alternatives;
  for (const double factor : kCoarser)
    alternatives.push_back({p.amplitude, p.length, factor * p.scale, factor * p.nugget});
  for (const double amplitude : kAmplitudes) {
    for (const double length : kLengths) {
      const ProcessParameters q{amplitude * least_amplitude, toRadians(length), p.scale, p.nugget};
      if (quickness(q) > quickness(p)) alternatives.push_back(q);
    }
  }
  return alternatives;
}

/// What is far off counts for what it is off, unless a neighbour is off the same way: that is a dip.
void doubtStrays(RingData& data, const ProcessParameters& p, RingProcess& result) {
  constexpr double kFar = 4.0, kAlso = 1.5;
  const std::size_t count = data.values.size();
  const OffOthers off = offOthers(data, p, result);
  const auto ratio = [&off](std::size_t i) { return off.distance[i] / off.sigma[i]; };
  const auto next = [&](std::size_t i, std::size_t step) {
    std::size_t j = (i + step) % count;
    while (j != i && !std::isfinite(data.values[j])) j = (j + step) % count;
    return j;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (std::abs(ratio(i)) <= kFar) continue;
    const auto follows = [&](std::size_t j) { return std::abs(ratio(j)) > kAlso && ratio(j) * ratio(i) > 0.0; };
    const std::size_t after = next(i, 1), before = next(i, count - 1);
    if (follows(after) || follows(before)) continue;
    result.doubt[i] = std::max(result.doubt[i], std::abs(ratio(i)));
    data.variances[i] += square(off.distance[i]) / (p.scale * p.scale);
    for (std::size_t j = (before + 1) % count; j != after; j = (j + 1) % count)
      result.strayed[j] = std::max(result.strayed[j], std::abs(off.distance[i]));
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
  followBends(data, p, alternativesTo(p, least_amplitude), result);
  for (const double variance : varianceOfShape(data, p, kOrder)) result.shape.push_back(std::sqrt(variance));
  for (std::size_t i = 0; i < values.size(); ++i)
    result.sigma[i] = std::hypot(std::hypot(result.sigma[i], result.shape[i]), kEither * result.strayed[i]);
  for (std::size_t i = 0; i < values.size(); ++i) result.value[i] += shape(static_cast<double>(i) * step);
  return result;
}

}  // namespace tank_datum
