#include "core/rounding_step.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {

double roundingStep(std::vector<double> values) {
  constexpr std::size_t kFewest = 20;  // gaps
  constexpr double kFar = 8.5;         // steps
  constexpr double kOff = 0.1;         // of a step
  constexpr double kMost = 0.9;        // of the gaps
  std::sort(values.begin(), values.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) gaps.push_back(values[i] - values[i - 1]);
  }
  if (gaps.size() < kFewest) return 0.0;
  const double least = *std::min_element(gaps.begin(), gaps.end());
  std::vector<double> single;  // coordinates have digits enough for a step, not for all of its own
  for (const double gap : gaps) {
    if (gap < (1.0 + kOff) * least) single.push_back(gap);
  }
  const double step = median(std::move(single));
  const auto is_multiple = [step](double gap) {
    const double steps = gap / step;
    return steps < kFar && std::abs(steps - std::round(steps)) < kOff;
  };
  const auto multiples = std::count_if(gaps.begin(), gaps.end(), is_multiple);
  return static_cast<double>(multiples) >= kMost * static_cast<double>(gaps.size()) ? step : 0.0;
}

double roundingError(double step, double scatter) {
  if (!(step > 0.0)) return 0.0;
  return step / std::sqrt(12.0) * portable::exp(-0.5 * square(kTwoPi * scatter / step));
}

double Rounding::errorOf(double own, double spread) const {
  const double before = square(std::min(own, scatter)) - square(step) / 6.0;  // without rounding, and the spreading
  return roundingError(step, std::sqrt(std::max(0.0, before) + square(spread)));
}

}  // namespace tank_datum
