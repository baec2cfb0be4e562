#include "setups/setup_groups.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/portable_math.h"
#include "core/statistics.h"

namespace tank_datum {
namespace {

/// How far apart the means of two groups are by chance once in 300 times, over what the setups of both scatter by:
/// found by drawing normal heights and parting them at every gap.
double boundOf(std::size_t setups) { return 4.0 + 27.0 / static_cast<double>(setups - 3); }

/// Numbers in a row, their mean and the sum of their squared distances from it.
struct Run {
  double mean = 0.0, squares = 0.0;
};

Run runOf(const std::vector<double>& values, std::size_t first, std::size_t last) {
  const auto count = static_cast<double>(last - first);
  Run run;
  for (std::size_t i = first; i < last; ++i) run.mean += values[i] / count;
  for (std::size_t i = first; i < last; ++i) run.squares += square(values[i] - run.mean);
  return run;
}

}  // namespace

const std::vector<bool>& SetupGroups::smaller() const {
  return std::count(higher.begin(), higher.end(), true) < std::count(lower.begin(), lower.end(), true) ? higher : lower;
}

SetupGroups twoGroups(const std::vector<double>& heights) {
  constexpr std::size_t kFewest = 2;  // setups of a group; one alone is a bad setup
  const std::vector<bool> none(heights.size(), false);
  SetupGroups groups{0.0, none, none};
  std::vector<double> sorted = finiteOf(heights);
  if (sorted.size() < 2 * kFewest) return groups;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t count = sorted.size();
  double farthest = boundOf(count), border = 0.0;
  for (std::size_t k = kFewest; k + kFewest <= count; ++k) {
    const Run lower = runOf(sorted, 0, k), upper = runOf(sorted, k, count);
    const double scatter = std::sqrt((lower.squares + upper.squares) / static_cast<double>(count - 2));
    const double between = upper.mean - lower.mean;
    if (!(between > farthest * scatter)) continue;
    farthest = between / scatter, groups.apart = between, border = 0.5 * (sorted[k - 1] + sorted[k]);
  }
  for (std::size_t s = 0; groups.found() && s < heights.size(); ++s) {
    groups.higher[s] = heights[s] > border;
    groups.lower[s] = heights[s] < border;
  }
  return groups;
}

}  // namespace tank_datum
