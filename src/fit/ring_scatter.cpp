#include "fit/ring_scatter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/portable_math.h"
#include "core/statistics.h"

namespace tank_datum {
namespace {

/// A value with its place along the ring, in steps.
struct KnownValue {
  double place, value, sigma;
};

/// Third divided difference of four values over its standard error.
double thirdDifference(const std::array<KnownValue, 4>& values) {
  double sum = 0, variance = 0;
  for (const KnownValue& v : values) {
    double weight = 1.0;
    for (const KnownValue& other : values) {
      if (&other != &v) weight /= v.place - other.place;
    }
    sum += weight * v.value;
    variance += square(weight * v.sigma);
  }
  return variance > 0.0 ? sum / std::sqrt(variance) : 0.0;
}

/// What values scatter by, in their standard errors, as differences of every so manieth of them show it; 0: too few do.
/// @param longest  that a difference may reach over [steps]
double scatterAt(const std::vector<KnownValue>& known, std::size_t lag, double ring, double longest) {
  constexpr std::size_t kFewest = 40;
  constexpr double kShare = 0.7, kWithin = 1.0364;  // of normal deviates
  std::vector<double> ratios;
  for (std::size_t i = 0; 3 * lag < known.size() && i < known.size(); ++i) {
    std::array<KnownValue, 4> four;
    for (std::size_t k = 0; k < four.size(); ++k) {
      const std::size_t at = i + k * lag;
      four[k] = known[at % known.size()];
      if (at >= known.size()) four[k].place += ring;
    }
    if (four.back().place - four.front().place <= longest) ratios.push_back(std::abs(thirdDifference(four)));
  }
  return ratios.size() < kFewest ? 0.0 : quantile(ratios, kShare) / kWithin;
}

}  // namespace

double ringScatter(const std::vector<double>& values, const std::vector<double>& sigmas) {
  constexpr std::size_t kApart = 3;          // values that share next to nothing
  constexpr double kLongest = 12.0 / 360.0;  // of the ring, over which what values follow is a parabola
  constexpr double kLost = 1.5;  // of the variance of third differences, times the correlation of neighbours
  constexpr double kMostShared = 0.5;
  constexpr double kChance = 2.0;  // of the square root of their number: how far two such scatters differ by chance
  std::vector<KnownValue> known;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) known.push_back({static_cast<double>(i), values[i], sigmas[i]});
  }
  const auto ring = static_cast<double>(values.size());
  const double near = scatterAt(known, 1, ring, kLongest * ring), far = scatterAt(known, kApart, ring, kLongest * ring);
  const double chance = kChance / std::sqrt(static_cast<double>(known.size()));
  if (!(far > near * (1.0 + chance))) return near;
  const double shared = std::min(kMostShared, (1.0 - square(near / far)) / kLost);
  return far * std::sqrt(1.0 + 2.0 * shared);
}

}  // namespace tank_datum
