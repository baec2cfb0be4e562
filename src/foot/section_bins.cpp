#include "foot/section_bins.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/parts.h"
#include "core/statistics.h"
#include "foot/lowest_layer.h"
#include "foot/overhang.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestPoints = 10;  // points that make a bin's median worth looking at
constexpr double kWidestBin = 0.04;        // of the reach, so that a section has some twenty
constexpr double kDeepest = 0.2;           // of the reach, what is seen below a lip's edge

/// The heights above their station's datum of all points, by bins of d, with several threads.
std::vector<std::vector<double>> heightsByBin(const std::vector<std::vector<FootPoint>>& stations,
                                              const std::vector<double>& datum, double reach, double bin) {
  const auto bins = static_cast<std::size_t>(std::ceil(reach / bin));
  const auto parts = ofParts(stations.size(), 0, [&](std::size_t begin, std::size_t end) {
    std::vector<std::vector<double>> heights(bins);
    for (std::size_t s = begin; s < end; ++s) {
      if (!std::isfinite(datum[s])) continue;
      for (const FootPoint& p : stations[s]) {
        if (p.d >= 0.0 && p.d < reach && std::abs(p.z - datum[s]) < reach) {
          heights[std::min(bins - 1, static_cast<std::size_t>(p.d / bin))].push_back(p.z - datum[s]);
        }
      }
    }
    return heights;
  });
  std::vector<std::vector<double>> heights(bins);
  forEachIndex(bins, 0, [&](std::size_t i) {
    for (const auto& part : parts) heights[i].insert(heights[i].end(), part[i].begin(), part[i].end());
  });
  return heights;
}

/// Bins wide enough that one holds a hundred points on the average.
double widthOfBins(const std::vector<std::vector<FootPoint>>& stations, double reach) {
  double points = 0;
  for (const auto& station : stations) points += static_cast<double>(station.size());
  return 100.0 * reach / std::max(1.0, points);
}

/// Whether most points beyond a distance from the shell lie in bins that hold too few of them to be looked at.
bool isPatchy(const std::vector<std::vector<double>>& heights, double bin, double from) {
  std::size_t enough = 0, few = 0;
  for (auto i = static_cast<std::size_t>(std::ceil(from / bin)); i < heights.size(); ++i)
    (heights[i].size() < kFewestPoints ? few : enough) += heights[i].size();
  return few > enough;
}

}  // namespace

void stackBins(FootProfile& profile, const std::vector<std::vector<FootPoint>>& stations,
               const std::vector<double>& datum, const FootScales& scales) {
  profile.bin = std::max({scales.reach / 100.0, scales.shell_noise, widthOfBins(stations, scales.reach)});
  const double layer = std::max(2.0 * profile.bin, 6.0 * scales.shell_noise);
  auto heights = heightsByBin(stations, datum, scales.reach, profile.bin);
  // the shell's points say nothing of how many lie before it
  while (!scales.arc && profile.bin < kWidestBin * scales.reach && isPatchy(heights, profile.bin, scales.nearest())) {
    profile.bin *= 2.0;
    heights = heightsByBin(stations, datum, scales.reach, profile.bin);
  }
  for (auto* column : {&profile.height, &profile.spread, &profile.error}) column->assign(heights.size(), kUnknown);
  const auto read = [&profile](std::size_t i, const std::vector<double>& values) {
    const bool few = values.size() < kFewestPoints;
    profile.height[i] = few ? kUnknown : median(values);
    profile.spread[i] = few ? kUnknown : robustSigma(values, profile.height[i]);
    profile.error[i] = few ? kUnknown : kMedianOverMean * std::max(profile.spread[i], 1e-6) / std::sqrt(values.size());
  };
  forEachIndex(heights.size(), 0, [&](std::size_t i) {
    std::vector<double> values = heights[i];
    if (!values.empty()) keepLowestLayer(values, layer);
    read(i, values);
  });
  const OverhangScales of{firstBeyondWeld(profile, scales), static_cast<std::size_t>(scales.overhang / profile.bin),
                          layer, kDeepest * scales.reach};
  const std::vector<double> overhang = overhangOf(heights, profile.height, of);
  if (!isSetBack(stations, datum, overhang, of, profile.bin, scales.blur())) return;
  for (std::size_t i = 0; i < overhang.size(); ++i) {
    if (!std::isfinite(overhang[i])) continue;
    std::vector<double>& values = heights[i];
    const auto is_off = [&](double z) { return std::abs(z - overhang[i]) > layer; };
    values.erase(std::remove_if(values.begin(), values.end(), is_off), values.end());
    read(i, values);
    profile.overhang = static_cast<double>(i + 1) * profile.bin;
  }
}

}  // namespace tank_datum
