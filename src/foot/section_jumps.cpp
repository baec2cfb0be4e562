#include "foot/section_jumps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.h"

namespace tank_datum {
namespace {

/// The bins with standard errors as large as they are seen to be: points of a bin lie in rows and on one patch of a
/// rough surface, so that it errs more than its points' scatter says. By second differences, of which a jump moves few.
std::vector<SectionBin> withErrorsSeen(std::vector<SectionBin> bins) {
  constexpr std::size_t kEnough = 6;
  std::vector<double> ratios;
  for (std::size_t i = 1; i + 1 < bins.size(); ++i) {
    const SectionBin &a = bins[i - 1], &b = bins[i], &c = bins[i + 1];
    const double share = (b.d - a.d) / (c.d - a.d);
    const double off = b.z - (1.0 - share) * a.z - share * c.z;
    ratios.push_back(off / std::hypot(b.error, std::hypot((1.0 - share) * a.error, share * c.error)));
  }
  const double scale = ratios.size() < kEnough ? 1.0 : std::max(1.0, robustSigma(ratios, 0.0));
  for (SectionBin& bin : bins) bin.error *= scale;
  return bins;
}

/// Whether one line, however steep, goes through the bins on both sides of a jump.
bool isOneLine(const std::vector<SectionBin>& bins, BinRange before, BinRange after, double least) {
  constexpr double kAnySlope = std::numeric_limits<double>::infinity();
  constexpr double kTolerance = 0.2, kMisfit = 4.0;
  std::vector<SectionBin> both;
  for (const BinRange& side : {before, after}) {
    for (std::size_t i = side.first; i < side.last; ++i) {
      both.push_back({bins[i].d, bins[i].z, std::hypot(bins[i].error, kTolerance * least)});
    }
  }
  if (both.size() < 4) return false;
  const SectionLine line = lineThrough(both, {0, both.size()}, kAnySlope);
  double misfit = 0;
  for (const SectionBin& bin : both) misfit += std::pow((bin.z - line.at(bin.d)) / bin.error, 2.0);
  return misfit < kMisfit * static_cast<double>(both.size() - 2);
}

}  // namespace

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
  for (std::size_t i = first; i < last; ++i) misfit += std::pow((bins[i].z - line.at(bins[i].d)) / bins[i].error, 2.0);
  const double larger = std::max(1.0, misfit / std::max(1.0, static_cast<double>(last - first) - 1.0));
  line.variance = larger / sum;
  line.variance_slope = larger / squares;
  return line;
}

Jump clearestJump(const std::vector<SectionBin>& given, const JumpScales& scales) {
  constexpr double kUsualSlope = 0.05;  // [m/m]
  constexpr double kEach = 0.1;
  const std::vector<SectionBin> bins = withErrorsSeen(given);
  Jump clearest;
  double best = 0.0;
  for (std::size_t end = 1; end < bins.size(); ++end) {
    std::size_t first = end - 1;
    while (first > 0 && bins[end - 1].d - bins[first - 1].d <= scales.length) --first;
    const SectionLine before = lineThrough(bins, {first, end}, kUsualSlope);
    for (std::size_t begin = end; begin < bins.size(); ++begin) {
      if (begin > end && bins[begin - 1].d - bins[end].d > scales.mixed) break;
      std::size_t last = begin + 1;
      while (last < bins.size() && bins[last].d - bins[begin].d <= scales.length) ++last;
      const SectionLine after = lineThrough(bins, {begin, last}, kUsualSlope);
      const double at = 0.5 * (bins[end - 1].d + bins[begin].d);
      const double error = 3.0 * std::sqrt(before.varianceAt(at) + after.varianceAt(at));
      const double over = std::abs(after.at(at) - before.at(at)) - scales.least - error;
      const double worth = over / (1.0 + kEach * static_cast<double>(begin - end));  // to leave bins out costs
      if (worth <= best || isOneLine(bins, {first, end}, {begin, last}, scales.least)) continue;
      best = worth;
      clearest = {end, begin, over};
    }
  }
  return clearest;
}

}  // namespace tank_datum
