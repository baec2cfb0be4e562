#include "fit/window_means.h"

#include <cmath>
#include <utility>

#include "core/units.h"

namespace tank_datum {

std::vector<Window> windowsOver(const std::vector<double>& directions, double width) {
  const std::size_t n = directions.size();
  const double half = 0.5 * width + 1e-9;
  std::vector<Window> windows;
  for (std::size_t i = 0; i < n; ++i) {
    const auto within = [&](std::size_t j) {
      return std::abs(std::remainder(directions[j] - directions[i], kTwoPi)) <= half;
    };
    std::size_t first = i, count = 1;
    while (count < n && within((first + n - 1) % n)) first = (first + n - 1) % n, ++count;
    while (count < n && within((first + count) % n)) ++count;
    windows.push_back({first, first + count});
  }
  return windows;
}

WindowMeans::WindowMeans(std::vector<Window> windows, std::vector<double> weights)
    : windows_(std::move(windows)), weights_(std::move(weights)), sums_(2 * weights_.size() + 1, 0.0) {
  constexpr double kRounding = 1e-9;  // of sums of weights
  sumUp([this](std::size_t i) { return weights_[i]; });
  for (const Window& w : windows_) {
    const double sum = sums_[w.end] - sums_[w.first];
    per_weight_.push_back(sum > kRounding * sums_[weights_.size()] ? 1.0 / sum : 0.0);
  }
}

void WindowMeans::of(const float* values, float* means) {
  sumUp([&](std::size_t i) { return weights_[i] * values[i]; });
  for (std::size_t w = 0; w < windows_.size(); ++w) {
    means[w] = static_cast<float>((sums_[windows_[w].end] - sums_[windows_[w].first]) * per_weight_[w]);
  }
}

template <typename Term>
void WindowMeans::sumUp(Term term) {
  const std::size_t n = weights_.size();
  for (std::size_t i = 0; i < n; ++i) sums_[i + 1] = sums_[i] + term(i);
  for (std::size_t i = 0; i < n; ++i) sums_[n + i + 1] = sums_[n] + sums_[i + 1];
}

}  // namespace tank_datum
