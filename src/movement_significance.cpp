#include "movement_significance.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tank_datum/statistics.h"
#include "units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kDraws = 2000;
constexpr double kFalseAlarms = 0.05;
constexpr double kWidthsDeg[] = {0.0, 3.0, 6.0, 12.0, 24.0, 48.0};  ///< whole

/// Stations first ... first + count - 1, counted on round the tank.
struct Window {
  std::size_t first = 0, end = 0;
  double per_weight = 0.0;  ///< 1 / sum of the weights
};

std::vector<Window> windowsOver(const std::vector<MatchedStation>& stations) {
  const std::size_t n = stations.size();
  std::vector<double> weights(2 * n + 1, 0.0);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    weights[i + 1] = weights[i] + 1.0 / (stations[i % n].sigma * stations[i % n].sigma);
  }
  std::vector<Window> windows;
  for (const double width : kWidthsDeg) {
    const double half = toRadians(width) / 2.0 + 1e-9;
    for (std::size_t i = 0; i < n; ++i) {
      const auto within = [&](std::size_t j) {
        return std::abs(std::remainder(stations[j].direction - stations[i].direction, kTwoPi)) <= half;
      };
      std::size_t first = i, count = 1;
      while (count < n && within((first + n - 1) % n)) first = (first + n - 1) % n, ++count;
      while (count < n && within((first + count) % n)) ++count;
      windows.push_back({first, first + count, 1.0 / (weights[first + count] - weights[first])});
    }
  }
  return windows;
}

/// Weighted means of dz, one per window, into `means`.
void meansOf(const std::vector<MatchedStation>& stations, const std::vector<Window>& windows, float* means) {
  const std::size_t n = stations.size();
  std::vector<double> sums(2 * n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) sums[i + 1] = sums[i] + stations[i].dz / (stations[i].sigma * stations[i].sigma);
  for (std::size_t i = 0; i < n; ++i) sums[n + i + 1] = sums[n] + sums[i + 1];
  for (const Window& w : windows) *means++ = static_cast<float>((sums[w.end] - sums[w.first]) * w.per_weight);
}

/// Leaves no station by itself (a Hampel filter): one that is further from the median of the stations within 2 degrees
/// than kOutlier of its sigmas is put there. A shell carries no step over one degree, but scans have single stations
/// seven sigmas off. Stations with fewer than four such neighbours stay as they are.
class Steadied {
 public:
  explicit Steadied(const std::vector<MatchedStation>& stations) {
    constexpr double kNear = 2.0 * kPi / 180.0 + 1e-6;
    const std::size_t n = stations.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto near = [&](std::size_t j) {
        return std::abs(std::remainder(stations[j].direction - stations[i].direction, kTwoPi)) <= kNear;
      };
      std::vector<std::size_t> beside = {i};
      for (std::size_t k = 1; k < n && near((i + k) % n); ++k) beside.push_back((i + k) % n);
      for (std::size_t k = 1; k < n && near((i + n - k) % n); ++k) beside.push_back((i + n - k) % n);
      if (beside.size() < 5) beside.clear();
      beside_.push_back(std::move(beside));
    }
  }

  /// The stations with their dz so treated.
  const std::vector<MatchedStation>& of(const std::vector<MatchedStation>& stations) {
    constexpr double kOutlier = 2.5;
    steadied_ = stations;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const double reach = kOutlier * stations[i].sigma;
      std::size_t far = 0;  // the median is no further off than half of the stations are
      for (const std::size_t j : beside_[i]) far += std::abs(stations[j].dz - stations[i].dz) > reach ? 1 : 0;
      if (2 * far < beside_[i].size() || beside_[i].empty()) continue;
      around_.clear();
      for (const std::size_t j : beside_[i]) around_.push_back(stations[j].dz);
      const auto middle = around_.begin() + static_cast<std::ptrdiff_t>(around_.size() / 2);
      std::nth_element(around_.begin(), middle, around_.end());
      if (std::abs(stations[i].dz - *middle) > reach) steadied_[i].dz = *middle;
    }
    return steadied_;
  }

 private:
  std::vector<std::vector<std::size_t>> beside_;
  std::vector<MatchedStation> steadied_;
  std::vector<double> around_;
};

/// Normal deviates that are the same on every machine: Box and Muller on a specified generator.
class Deviates {
 public:
  double operator()() {
    if (kept_ready_) {
      kept_ready_ = false;
      return kept_;
    }
    constexpr double kUnit = 1.0 / 18446744073709551616.0;
    const double u = (static_cast<double>(generator_()) + 0.5) * kUnit, v = static_cast<double>(generator_()) * kUnit;
    const double r = std::sqrt(-2.0 * std::log(std::min(u, 1.0)));
    kept_ = r * std::sin(kTwoPi * v), kept_ready_ = true;
    return r * std::cos(kTwoPi * v);
  }

 private:
  std::mt19937_64 generator_{20180419};
  double kept_ = 0.0;
  bool kept_ready_ = false;
};

/// Comparisons of an unmoved tank. A station's error is the mean of white noise along its window, so that stations
/// share errors as far as they share points.
class Unmoved {
 public:
  Unmoved(const std::vector<MatchedStation>& stations, const CommonErrors& common, const MovementOptions& options)
      : stations_(stations), common_(common), part_(stations, options.removal) {
    cells_ = std::max<std::size_t>(360, stations.size());
    const double cell = kTwoPi / static_cast<double>(cells_);
    for (const MatchedStation& m : stations) {
      const double window = options.correlation > 0.0 ? options.correlation : m.window;
      const double most = 0.5 * static_cast<double>(cells_);
      const auto width = static_cast<std::size_t>(std::clamp(std::ceil(window / cell - 1e-6), 1.0, most));
      const double start = std::round(m.direction / cell - 0.5 * static_cast<double>(width));
      const auto first = static_cast<std::size_t>(start < 0.0 ? start + static_cast<double>(cells_) : start);
      shares_.push_back({first % cells_, width, 1.0 / std::sqrt(static_cast<double>(width))});
    }
  }

  /// The stations with errors alone for dz.
  const std::vector<MatchedStation>& draw() {
    std::vector<double> sums(2 * cells_ + 1, 0.0);
    for (std::size_t i = 0; i < cells_; ++i) sums[i + 1] = sums[i] + normal_();
    for (std::size_t i = 0; i < cells_; ++i) sums[cells_ + i + 1] = sums[cells_] + sums[i + 1];
    const double turn = common_.turn * normal_();
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Share& s = shares_[i];
      const double error = (sums[s.first + s.width] - sums[s.first]) * s.scale;
      stations_[i].dz = stations_[i].sigma * error + stations_[i].slope * turn;
    }
    part_.removeFrom(stations_);
    const double height = common_.height * normal_(), east = common_.rim * normal_(), north = common_.rim * normal_();
    for (MatchedStation& m : stations_) m.dz += height + east * std::cos(m.direction) + north * std::sin(m.direction);
    return stations_;
  }

 private:
  struct Share {
    std::size_t first, width;
    double scale;
  };
  std::vector<MatchedStation> stations_;
  CommonErrors common_;
  CommonPart part_;
  std::size_t cells_ = 0;
  std::vector<Share> shares_;
  Deviates normal_;
};

/// A wide window may be carried by a movement at its edge: its middle must have moved too, by half as much.
bool middleMoved(const std::vector<float>& means, std::size_t window, std::size_t stations) {
  if (window < stations) return true;
  const float inner = means[window - stations], outer = means[window];
  return inner / outer >= 0.5F;
}

}  // namespace

Significance findMoved(const std::vector<MatchedStation>& stations, const CommonErrors& common,
                       const MovementOptions& options) {
  const std::vector<Window> windows = windowsOver(stations);
  Unmoved unmoved(stations, common, options);
  Steadied steadied(stations);
  const std::size_t count = windows.size();
  std::vector<float> draws(kDraws * count);
  std::vector<double> sigmas(count, 0.0), maxima;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    float* means = &draws[draw * count];
    meansOf(steadied.of(unmoved.draw()), windows, means);
    for (std::size_t w = 0; w < count; ++w) sigmas[w] += means[w] * means[w];
  }
  for (double& sigma : sigmas) sigma = std::sqrt(sigma / kDraws);
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    double largest = 0.0;
    for (std::size_t w = 0; w < count; ++w) largest = std::max(largest, std::abs(draws[draw * count + w]) / sigmas[w]);
    maxima.push_back(largest);
  }
  Significance result;
  result.threshold = quantile(maxima, 1.0 - kFalseAlarms);
  result.moved.assign(stations.size(), false);
  std::vector<float> means(count);
  meansOf(steadied.of(stations), windows, means.data());
  for (std::size_t w = 0; w < count; ++w) {
    const bool found = std::abs(means[w]) > result.threshold * sigmas[w];
    if (found && middleMoved(means, w, stations.size())) result.moved[w % stations.size()] = true;
  }
  for (const MatchedStation& m : stations) {
    const double own = std::hypot(m.sigma, m.slope * common.turn);
    result.sigmas.push_back(std::hypot(own, std::hypot(common.height, common.rim)));
  }
  return result;
}

}  // namespace tank_datum
