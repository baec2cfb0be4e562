#include "core/rounding_step.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// A value, and how many are alike to it.
struct ValueLevel {
  double value = 0.0;
  std::size_t count = 0;
};

/// @param alike  what values differ by that are one
std::vector<ValueLevel> levelsOf(const std::vector<double>& sorted, double alike) {
  std::vector<ValueLevel> levels;
  for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
    for (end = first + 1; end < sorted.size() && sorted[end] - sorted[end - 1] <= alike; ++end) continue;
    levels.push_back({sorted[first], end - first});
  }
  return levels;
}

/// How many values the fewest-valued of those levels has that hold so many together, the most-valued first, and are at
/// least so many.
std::size_t fewestOfFullest(const std::vector<ValueLevel>& levels, double values, std::size_t many) {
  std::vector<std::size_t> counts;
  for (const ValueLevel& level : levels) counts.push_back(level.count);
  std::sort(counts.rbegin(), counts.rend());
  double held = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    held += static_cast<double>(counts[i]);
    if (held >= values && i + 1 >= many) return counts[i];
  }
  return 0;
}

/// The values that so many or more are alike to.
struct Shared {
  std::vector<double> levels;
  std::size_t held = 0;  ///< values that are so

  Shared(const std::vector<ValueLevel>& all, std::size_t fewest) {
    for (const ValueLevel& level : all) {
      if (level.count >= fewest) levels.push_back(level.value), held += level.count;
    }
  }
};

/// The gap of which most gaps between levels are multiples; 0: there is none.
/// @param fewest  levels that tell
/// @param far     the largest multiple that tells, in steps
double stepBetween(const std::vector<double>& levels, std::size_t fewest, double far) {
  constexpr double kOff = 0.2;   // of a step: so few digits float32 may have left
  constexpr double kMost = 0.9;  // of the gaps
  if (levels.size() < fewest) return 0.0;
  std::vector<double> gaps, single;
  for (std::size_t i = 1; i < levels.size(); ++i) gaps.push_back(levels[i] - levels[i - 1]);
  const double least = *std::min_element(gaps.begin(), gaps.end());
  std::copy_if(gaps.begin(), gaps.end(), std::back_inserter(single),
               [least](double gap) { return gap < (1.0 + kOff) * least; });
  const double step = std::accumulate(single.begin(), single.end(), 0.0) / static_cast<double>(single.size());
  const auto is_multiple = [step, far](double gap) {
    const double steps = gap / step;
    return steps < far && std::abs(steps - std::round(steps)) < kOff;
  };
  const auto multiples = std::count_if(gaps.begin(), gaps.end(), is_multiple);
  return static_cast<double>(multiples) >= kMost * static_cast<double>(gaps.size()) ? step : 0.0;
}

constexpr double kAlike = 0.01;            // of the finest step: sums of the same digits
constexpr double kShare = 0.2;             // of the values: others may not be rounded
constexpr std::size_t kFewestSingle = 21;  // levels
constexpr std::size_t kMany = 8;           // values of a level, which are not alike by chance

}  // namespace

double roundingStep(std::vector<double> values, double finest) {
  constexpr std::size_t kFewest = 4;  // levels
  constexpr double kFar = 8.5;        // steps
  std::sort(values.begin(), values.end());
  const std::vector<ValueLevel> levels = levelsOf(values, kAlike * finest);
  const double enough = kShare * static_cast<double>(values.size());
  // a few values may be alike by chance, many are not: fullest first, as means of rounded values lie in between
  std::vector<std::size_t> wanted{kMany, 3, 2, 1};
  if (const std::size_t fullest = fewestOfFullest(levels, enough, 1); fullest > kMany)
    wanted.insert(wanted.begin(), fullest);
  for (const std::size_t fewest : wanted) {
    const Shared shared(levels, fewest);
    if (static_cast<double>(shared.held) < enough) continue;
    const double step = stepBetween(shared.levels, fewest > 1 ? kFewest : kFewestSingle, kFar);
    if (step >= finest) return step;
  }
  return 0.0;
}

double roundingStepBesideFloor(std::vector<double> values, double finest) {
  std::sort(values.begin(), values.end());
  const std::vector<ValueLevel> levels = levelsOf(values, kAlike * finest);
  const std::size_t fewest = fewestOfFullest(levels, kShare * static_cast<double>(values.size()), kFewestSingle);
  if (fewest <= kMany) return 0.0;
  const double step = stepBetween(Shared(levels, fewest).levels, kFewestSingle, HUGE_VAL);
  return step >= finest ? step : 0.0;
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
