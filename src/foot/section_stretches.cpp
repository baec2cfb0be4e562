#include "foot/section_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tank_datum {
namespace {

constexpr double kUsualSlope = 0.05;  // [m/m]

/// Sums over the first bins, from which those of any range are taken.
struct Sums {
  double w = 0, d = 0, z = 0, dd = 0, dz = 0, zz = 0;

  Sums plus(double weight, double at, double height) const {
    return {w + weight,
            d + weight * at,
            z + weight * height,
            dd + weight * at * at,
            dz + weight * at * height,
            zz + weight * height * height};
  }
  Sums minus(const Sums& o) const { return {w - o.w, d - o.d, z - o.z, dd - o.dd, dz - o.dz, zz - o.zz}; }

  /// Sum of squares about the best line, whose slope is observed beside as 0.
  double misfit() const {
    const double squares = dd - d * d / w + 1.0 / (kUsualSlope * kUsualSlope), products = dz - d * z / w;
    return std::max(0.0, zz - z * z / w - products * products / squares);
  }
};

std::vector<Sums> sumsOf(const std::vector<SectionBin>& bins, double tolerance) {
  std::vector<Sums> sums(1);
  for (const SectionBin& bin : bins) {
    const double error = std::hypot(bin.error, tolerance);
    sums.push_back(sums.back().plus(1.0 / (error * error), bin.d - bins.front().d, bin.z - bins.front().z));
  }
  return sums;
}

/// How far the lines of two stretches are apart where they should meet, beyond what is no step. One beside the shell
/// that is long enough to be a surface of its own needs no other: it ends at a lesser step than a short one, which may
/// be a blend with the shell.
double stepBetween(const std::vector<SectionBin>& bins, BinRange before, BinRange after, const StepScales& scales) {
  constexpr double kLong = 0.65;   // of the lines: 40 mm, which the narrowest lips are
  constexpr double kLesser = 0.4;  // of the least step
  while (bins[before.last - 1].d - bins[before.first].d > scales.length) ++before.first;
  while (bins[after.last - 1].d - bins[after.first].d > scales.length) --after.last;
  const SectionLine a = lineThrough(bins, before, kUsualSlope), b = lineThrough(bins, after, kUsualSlope);
  const double at = 0.5 * (bins[before.last - 1].d + bins[after.first].d),
               length = bins[before.last - 1].d - bins[before.first].d;
  const double error = std::sqrt(a.varianceAt(at) + b.varianceAt(at));
  const double none =
      length < kLong * scales.length ? scales.least + 3.0 * error : kLesser * scales.least + 2.0 * error;
  return std::abs(b.at(at) - a.at(at)) - none;
}

}  // namespace

std::vector<BinRange> stretchesOf(const std::vector<SectionBin>& bins, double tolerance) {
  constexpr double kStretch = 12.0, kLeftOut = 6.0;  // costs, as squares of standard errors
  const std::vector<Sums> sums = sumsOf(bins, tolerance);
  std::vector<double> least(bins.size() + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(bins.size() + 1, 0);  // the same as the index: the bin before is left out
  least[0] = 0.0;
  for (std::size_t end = 1; end <= bins.size(); ++end) {
    least[end] = least[end - 1] + kLeftOut, from[end] = end;
    for (std::size_t begin = 0; begin + 1 < end; ++begin) {
      const double cost = least[begin] + kStretch + sums[end].minus(sums[begin]).misfit();
      if (cost < least[end]) least[end] = cost, from[end] = begin;
    }
  }
  std::vector<BinRange> stretches;
  for (std::size_t end = bins.size(); end > 0;) {
    if (from[end] == end) {
      --end;
      continue;
    }
    stretches.push_back({from[end], end});
    end = from[end];
  }
  std::reverse(stretches.begin(), stretches.end());
  return stretches;
}

std::size_t binsBeforeStep(const std::vector<SectionBin>& given, const StepScales& scales) {
  constexpr double kTolerance = 0.2;  // of the least step
  const std::vector<SectionBin> bins = withErrorsSeen(given);
  const std::vector<BinRange> stretches = stretchesOf(bins, kTolerance * scales.least);
  if (stretches.empty()) return bins.size();
  BinRange surface = stretches.front();
  for (std::size_t k = 1; k < stretches.size(); ++k) {
    const BinRange& next = stretches[k];
    if (bins[next.last - 1].d - bins[next.first].d < scales.mixed) continue;
    if (stepBetween(bins, surface, next, scales) > 0.0) return surface.last;
    surface.last = next.last;
  }
  // what is last goes nowhere as a blend or a groove does: beyond a step it is what lies there, however little of it
  const BinRange& last = stretches.back();
  const bool ends = last.first >= surface.last && stepBetween(bins, surface, last, scales) > 0.0;
  return ends ? surface.last : std::max(surface.last, last.last);
}

}  // namespace tank_datum
