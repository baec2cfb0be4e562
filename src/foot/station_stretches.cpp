#include "foot/station_stretches.h"

#include <algorithm>
#include <cmath>

namespace tank_datum {
namespace {

/// The station nearest to the middle of a stretch's points, of those that have points and may be fitted.
std::size_t stationAtPoints(const std::vector<std::size_t>& counts, const std::vector<bool>& fitted, std::size_t first,
                            std::size_t count) {
  double points = 0, moment = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    points += static_cast<double>(counts[i]);
    moment += static_cast<double>(counts[i] * (i - first));
  }
  std::size_t best = first + count / 2;
  double nearest = static_cast<double>(count);
  for (std::size_t i = first; i < first + count; ++i) {
    const double away = std::abs(static_cast<double>(i - first) - moment / points);
    if (counts[i] > 0 && fitted[i] && away < nearest) nearest = away, best = i;
  }
  return best;
}

}  // namespace

std::vector<StationStretch> stretchesOf(const std::vector<std::size_t>& counts, const std::vector<bool>& fitted,
                                        std::size_t longest) {
  constexpr std::size_t kEnough = 8;
  std::vector<StationStretch> stretches;
  for (std::size_t i = 0; i < counts.size();) {
    if (counts[i] == 0) {
      ++i;
      continue;
    }
    std::size_t points = 0, length = 0;
    for (std::size_t k = 0; k < longest && i + k < counts.size() && points < kEnough; ++k) {
      points += counts[i + k];
      if (counts[i + k] > 0) length = k + 1;
    }
    stretches.push_back({i, length, stationAtPoints(counts, fitted, i, length)});
    i += length;
  }
  return stretches;
}

}  // namespace tank_datum
