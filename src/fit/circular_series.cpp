#include "fit/circular_series.h"

#include <cmath>

#include "core/statistics.h"

namespace tank_datum {

std::vector<double> filledUp(const std::vector<double>& values) {
  const std::size_t count = values.size();
  std::vector<double> filled = values;
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(values[i])) continue;
    std::size_t left = 1, right = 1;
    while (left < count && !std::isfinite(values[(i + count - left) % count])) ++left;
    while (right < count && !std::isfinite(values[(i + right) % count])) ++right;
    if (left == count) return values;
    const double share = static_cast<double>(left) / static_cast<double>(left + right);
    filled[i] = (1.0 - share) * values[(i + count - left) % count] + share * values[(i + right) % count];
  }
  return filled;
}

std::vector<double> runningMedian(const std::vector<double>& values, int reach) {
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  std::vector<double> result;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    std::vector<double> around;
    for (std::ptrdiff_t j = i - reach; j <= i + reach; ++j) {
      const double value = values[static_cast<std::size_t>((j + count) % count)];
      if (std::isfinite(value)) around.push_back(value);
    }
    result.push_back(median(around));
  }
  return result;
}

}  // namespace tank_datum
