#include "foot/section_lines.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"

namespace tank_datum {
namespace {

/// How far each bin but the first and the last lies off its neighbours, over what their standard errors allow.
std::vector<double> offNeighbours(const std::vector<SectionBin>& bins) {
  std::vector<double> ratios;
  for (std::size_t i = 1; i + 1 < bins.size(); ++i) {
    const SectionBin &a = bins[i - 1], &b = bins[i], &c = bins[i + 1];
    const double share = (b.d - a.d) / (c.d - a.d);
    const double off = b.z - (1.0 - share) * a.z - share * c.z;
    ratios.push_back(off / std::hypot(b.error, std::hypot((1.0 - share) * a.error, share * c.error)));
  }
  return ratios;
}

}  // namespace

std::vector<SectionBin> withErrorsSeen(std::vector<SectionBin> bins) {
  constexpr std::size_t kNearby = 5, kEnough = 6;  // bins to either side; differences
  const std::vector<double> ratios = offNeighbours(bins);
  if (ratios.size() < kEnough) return bins;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const std::size_t middle = std::min(i > 0 ? i - 1 : 0, ratios.size() - 1);
    const std::size_t first = std::min(middle - std::min(middle, kNearby), ratios.size() - kEnough);
    const std::size_t last = std::min(ratios.size(), std::max(middle + kNearby + 1, first + kEnough));
    const std::vector<double> nearby(ratios.begin() + static_cast<std::ptrdiff_t>(first),
                                     ratios.begin() + static_cast<std::ptrdiff_t>(last));
    bins[i].error *= std::max(1.0, robustSigma(nearby, 0.0));
  }
  return bins;
}

SectionLine lineThrough(const std::vector<SectionBin>& bins, BinRange range, double steepest) {
  SectionLine line;
  const auto [first, last] = range;
  double sum = 0, squares = 1.0 / (steepest * steepest), products = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double weight = 1.0 / (bins[i].error * bins[i].error);
    sum += weight;
    line.middle += weight * bins[i].d;
    line.height += weight * bins[i].z;
  }
  line.middle /= sum;
  line.height /= sum;
  for (std::size_t i = first; i < last; ++i) {
    const double weight = 1.0 / (bins[i].error * bins[i].error), d = bins[i].d - line.middle;
    squares += weight * d * d;
    products += weight * d * (bins[i].z - line.height);
  }
  line.slope = products / squares;
  double misfit = line.slope * line.slope / (steepest * steepest);
  for (std::size_t i = first; i < last; ++i) misfit += square((bins[i].z - line.at(bins[i].d)) / bins[i].error);
  const double larger = std::max(1.0, misfit / std::max(1.0, static_cast<double>(last - first) - 1.0));
  line.variance = larger / sum;
  line.variance_slope = larger / squares;
  return line;
}

}  // namespace tank_datum
