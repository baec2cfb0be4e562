#include "movement_significance.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tank_datum/statistics.h"
#include "units.h"

namespace tank_datum {
namespace {

constexpr int kDraws = 2000;
constexpr double kFalseAlarms = 0.05;
constexpr double kWindowsDeg[] = {0.0, 3.0, 6.0, 12.0, 24.0, 48.0};  ///< whole widths

/// Stations first ... first + count - 1, counted on round the tank.
struct Window {
  std::size_t first = 0, count = 0;
};

std::vector<Window> windowsOver(const std::vector<MatchedStation>& stations) {
  const std::size_t n = stations.size();
  std::vector<Window> windows;
  for (const double width : kWindowsDeg) {
    const double half = toRadians(width) / 2.0 + 1e-9;
    for (std::size_t i = 0; i < n; ++i) {
      const auto within = [&](std::size_t j) {
        return std::abs(std::remainder(stations[j].direction - stations[i].direction, kTwoPi)) <= half;
      };
      Window window{i, 1};
      while (window.count < n && within((window.first + n - 1) % n))
        window = {(window.first + n - 1) % n, window.count + 1};
      while (window.count < n && within((window.first + window.count) % n)) ++window.count;
      windows.push_back(window);
    }
  }
  return windows;
}

/// Weighted means of dz, one per window.
std::vector<double> meansOf(const std::vector<MatchedStation>& stations, const std::vector<Window>& windows) {
  const std::size_t n = stations.size();
  std::vector<double> weights(2 * n + 1, 0.0), sums(2 * n + 1, 0.0);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const MatchedStation& m = stations[i % n];
    const double weight = 1.0 / (m.sigma * m.sigma);
    weights[i + 1] = weights[i] + weight;
    sums[i + 1] = sums[i] + weight * m.dz;
  }
  std::vector<double> means;
  means.reserve(windows.size());
  for (const Window& w : windows) {
    const std::size_t end = w.first + w.count;
    means.push_back((sums[end] - sums[w.first]) / (weights[end] - weights[w.first]));
  }
  return means;
}

/// Normal deviates that are the same on every machine: Box and Muller on a specified generator.
class Deviates {
 public:
  double operator()() {
    constexpr double kUnit = 1.0 / 18446744073709551616.0;
    const double u = (static_cast<double>(generator_()) + 0.5) * kUnit, v = static_cast<double>(generator_()) * kUnit;
    return std::sqrt(-2.0 * std::log(std::min(u, 1.0))) * std::cos(kTwoPi * v);
  }

 private:
  std::mt19937_64 generator_{20180419};
};

/// The stations with errors alone for dz, as an unmoved tank would show.
std::vector<MatchedStation> unmoved(std::vector<MatchedStation> stations, const MovementOptions& options,
                                    const CommonErrors& common, Deviates& normal) {
  double error = normal();
  const double turn = common.turn * normal();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0) {
      const double arc = stations[i].direction - stations[i - 1].direction;
      const double kept = options.correlation > 0.0 ? std::exp(-arc / options.correlation) : 0.0;
      error = kept * error + std::sqrt(1.0 - kept * kept) * normal();
    }
    stations[i].dz = stations[i].sigma * error + stations[i].slope * turn;
  }
  removeCommon(stations, options.removal);
  const double height = common.height * normal(), east = common.rim * normal(), north = common.rim * normal();
  for (MatchedStation& m : stations) m.dz += height + east * std::cos(m.direction) + north * std::sin(m.direction);
  return stations;
}

}  // namespace

Significance findMoved(const std::vector<MatchedStation>& stations, const CommonErrors& common,
                       const MovementOptions& options) {
  const std::vector<Window> windows = windowsOver(stations);
  std::vector<std::vector<double>> draws;
  std::vector<double> sigmas(windows.size(), 0.0);
  Deviates normal;
  for (int draw = 0; draw < kDraws; ++draw) {
    draws.push_back(meansOf(unmoved(stations, options, common, normal), windows));
    for (std::size_t w = 0; w < windows.size(); ++w) sigmas[w] += draws.back()[w] * draws.back()[w] / kDraws;
  }
  for (double& sigma : sigmas) sigma = std::sqrt(sigma);
  const auto largest = [&sigmas](const std::vector<double>& means) {
    double result = 0.0;
    for (std::size_t w = 0; w < means.size(); ++w) result = std::max(result, std::abs(means[w]) / sigmas[w]);
    return result;
  };
  std::vector<double> maxima;
  for (const auto& means : draws) maxima.push_back(largest(means));

  Significance result;
  result.threshold = quantile(maxima, 1.0 - kFalseAlarms);
  result.moved.assign(stations.size(), false);
  const std::vector<double> means = meansOf(stations, windows);
  for (std::size_t w = 0; w < windows.size(); ++w) {
    if (std::abs(means[w]) > result.threshold * sigmas[w]) result.moved[w % stations.size()] = true;
  }
  for (const MatchedStation& m : stations) {
    result.sigmas.push_back(
        std::hypot(std::hypot(m.sigma, m.slope * common.turn), std::hypot(common.height, common.rim)));
  }
  return result;
}

}  // namespace tank_datum
