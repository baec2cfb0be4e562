#include "foot/overhang.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

std::size_t countBetween(const std::vector<double>& values, double from, double to) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](double z) { return z >= from && z <= to; }));
}

/// Whether the shell is seen below a surface, as under a drip ring.
bool hasShellBelow(const std::vector<double>& shell, double level, const OverhangScales& scales) {
  constexpr double kFew = 0.1;
  const double depth = scales.deepest - scales.layer;
  const auto below = static_cast<double>(countBetween(shell, level - scales.deepest, level - scales.layer)),
             above = static_cast<double>(countBetween(shell, level + scales.layer, level + scales.layer + depth));
  return below > kFew * above;
}

}  // namespace

std::vector<double> overhangOf(const std::vector<std::vector<double>>& heights, const std::vector<double>& lowest,
                               const OverhangScales& scales) {
  constexpr std::size_t kStart = 3;  // bins beside the shell
  constexpr double kPart = 0.1;      // of a bin's points that lie on it
  constexpr double kFewest = 10.0;   // of them
  constexpr std::size_t kGap = 3;    // bins that rows of points pass over
  const std::size_t count = heights.size();
  std::vector<double> over(count, kUnknown), beside;
  for (std::size_t i = scales.first; i < std::min(count, scales.first + kStart); ++i) beside.push_back(lowest[i]);
  double level = median(beside);
  if (finiteOf(beside).size() < kStart || hasShellBelow(heights.front(), level, scales)) return over;
  for (std::size_t i = scales.first, last = i; i < std::min(count, std::max(last + kGap + 2, scales.known)); ++i) {
    const double off = lowest[i] - level;
    if (off > scales.layer || off < -scales.deepest) break;
    if (off >= -scales.layer) {
      level = lowest[i], last = i;
      continue;
    }
    const auto on = static_cast<double>(countBetween(heights[i], level - scales.layer, level + scales.layer));
    if (on < kFewest || on < kPart * static_cast<double>(heights[i].size())) continue;
    std::fill(over.begin() + static_cast<std::ptrdiff_t>(last) + 1, over.begin() + static_cast<std::ptrdiff_t>(i) + 1,
              level);
    last = i;
  }
  return over;
}

bool isSetBack(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
               const std::vector<double>& over, const OverhangScales& scales, double bin, double blur) {
  constexpr std::size_t kFewest = 3;  // points of a station that tell
  constexpr double kFrom = 0.1;       // of the lower ones begin nearer, of the lip's end farther out
  if (finiteOf(over).empty()) return false;
  std::size_t told = 0, set_back = 0;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    if (!std::isfinite(datum[s])) continue;
    std::vector<double> lip, lower;
    for (const FootPoint& p : stations[s]) {
      const auto i = static_cast<std::size_t>(std::max(0.0, p.d) / bin);
      if (i >= over.size() || !std::isfinite(over[i])) continue;
      const double below = over[i] - (p.z - datum[s]);
      if (std::abs(below) <= scales.layer) lip.push_back(p.d);
      if (below > scales.layer && below < scales.deepest + scales.layer) lower.push_back(p.d);
    }
    if (lip.size() < kFewest && lower.size() < kFewest) continue;
    ++told;
    if (lip.size() < kFewest || lower.size() < kFewest) continue;
    set_back += quantile(std::move(lip), 1.0 - kFrom) - quantile(std::move(lower), kFrom) > blur ? 1 : 0;
  }
  return 2 * set_back > told;
}

}  // namespace tank_datum
