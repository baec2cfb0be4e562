#include "report/sparkline.h"

#include <algorithm>
#include <cmath>

#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr const char* kBlocks[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};

/// Mean elevation of the stations [from, to) that have one; NaN when none has [m].
double meanOf(const std::vector<Station>& stations, std::size_t from, std::size_t to) {
  double sum = 0.0;
  int known = 0;
  for (std::size_t i = from; i < to; ++i) {
    if (!std::isfinite(stations[i].z)) continue;
    sum += stations[i].z;
    ++known;
  }
  return known > 0 ? sum / known : kUnknown;
}

}  // namespace

std::string sparkline(const std::vector<Station>& stations, std::size_t columns) {
  columns = std::min(columns, stations.size());
  std::vector<double> means;
  for (std::size_t c = 0; c < columns; ++c) {
    means.push_back(meanOf(stations, c * stations.size() / columns, (c + 1) * stations.size() / columns));
  }
  double low = INFINITY, high = -INFINITY;
  for (const double z : means) {
    if (std::isfinite(z)) low = std::min(low, z), high = std::max(high, z);
  }
  std::string row;
  for (const double z : means) {
    const double share = high > low ? (z - low) / (high - low) : 0.5;
    row += std::isfinite(z) ? kBlocks[std::min(7, static_cast<int>(8.0 * share))] : " ";
  }
  return row;
}

}  // namespace tank_datum
