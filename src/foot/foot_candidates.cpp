#include "foot/foot_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "foot/foot_profile.h"
#include "foot/lowest_layer.h"

namespace tank_datum {
namespace {

struct Bin {
  double d, z, spread, error;
};

/// Bins that hold eight points on the average, no finer than a fiftieth of the reach or the shell's noise.
std::vector<Bin> binsOf(const std::vector<FootPoint>& points, const FootScales& scales, double near) {
  constexpr double kPointsPerBin = 8.0;
  constexpr std::size_t kFewest = 3;
  const auto inside = [&](const FootPoint& p) { return p.d >= near && p.d < scales.reach; };
  const auto count = static_cast<double>(std::count_if(points.begin(), points.end(), inside));
  if (count < kPointsPerBin) return {};
  const double length = scales.reach - near;
  const double width = std::max({scales.reach / 50.0, scales.shell_noise, length * kPointsPerBin / count});
  std::vector<std::vector<double>> heights(static_cast<std::size_t>(length / width) + 1);
  for (const FootPoint& p : points) {
    if (inside(p)) heights[static_cast<std::size_t>((p.d - near) / width)].push_back(p.z);
  }
  const double layer = std::max(0.02 * scales.reach, 6.0 * scales.shell_noise);
  std::vector<Bin> bins;
  std::vector<double> spreads;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i].size() < kFewest) continue;
    keepLowestLayer(heights[i], layer);
    if (heights[i].size() < kFewest) continue;
    const double z = median(heights[i]), spread = robustSigma(heights[i], z);
    bins.push_back({near + (static_cast<double>(i) + 0.5) * width, z, spread,
                    1.2533 / std::sqrt(static_cast<double>(heights[i].size()))});
    spreads.push_back(spread);
  }
  const double typical = std::max(median(spreads), 1e-7);  // of few points a spread may be nought by chance
  for (Bin& bin : bins) bin.error *= std::max(bin.spread, typical);
  return bins;
}

bool isStep(const Bin& a, const Bin& b, double reach) {
  constexpr double kStep = 0.005;  // of the reach
  constexpr double kRamp = 0.10;   // the steepest slope of a foundation surface [m/m]
  return std::abs(a.z - b.z) > kStep * reach + kRamp * (b.d - a.d) + 3.0 * std::hypot(a.error, b.error);
}

/// The line through a run of bins: median of the slopes between its thirds, median of the offsets.
FootCandidate lineThrough(const std::vector<Bin>& run, double width) {
  std::vector<double> slopes, offsets, spreads;
  const std::size_t apart = std::max<std::size_t>(1, (run.size() - 1) / 3);
  for (std::size_t i = 0; i < run.size(); ++i) {
    for (std::size_t j = i + apart; j < run.size(); ++j)
      slopes.push_back((run[j].z - run[i].z) / (run[j].d - run[i].d));
  }
  FootCandidate line;
  line.slope = median(slopes);
  double mean = 0, squares = 0, errors = 0;
  for (const Bin& bin : run) {
    offsets.push_back(bin.z - line.slope * bin.d);
    spreads.push_back(bin.spread);
    mean += bin.d / static_cast<double>(run.size());
  }
  for (const Bin& bin : run) {
    squares += (bin.d - mean) * (bin.d - mean);
    errors += bin.error * bin.error / static_cast<double>(run.size());
  }
  line.height = median(offsets);
  line.noise = median(spreads);
  line.sigma_slope = std::sqrt(errors / squares);
  line.error = std::sqrt(errors * (1.0 / static_cast<double>(run.size()) + mean * mean / squares));
  line.from = run.front().d - 0.5 * width;
  line.to = run.back().d + 0.5 * width;
  return line;
}

/// The elevation that the shell is seen down to, but for a stray point or two.
double endOfShell(const std::vector<FootPoint>& points, double noise) {
  constexpr std::size_t kStray = 2;
  std::vector<double> z;
  for (const FootPoint& p : points) {
    if (std::abs(p.d) < 3.0 * noise) z.push_back(p.z);
  }
  const std::size_t at = kStray + z.size() / 500;
  if (at >= z.size()) return std::numeric_limits<double>::quiet_NaN();
  std::nth_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(at), z.end());
  return z[at];
}

}  // namespace

std::vector<FootCandidate> findCandidates(const std::vector<FootPoint>& points, const FootScales& scales) {
  constexpr std::size_t kFewestBins = 2;
  const double near = std::max(scales.weld, 3.0 * scales.shell_noise);
  const std::vector<Bin> bins = binsOf(points, scales, near);
  std::vector<FootCandidate> candidates;
  if (bins.size() < kFewestBins) return candidates;
  const double width = (bins.back().d - bins.front().d) / static_cast<double>(bins.size() - 1);
  const double end = endOfShell(points, scales.shell_noise);
  std::vector<Bin> run;
  const auto close = [&] {
    if (run.size() >= kFewestBins) {
      candidates.push_back(lineThrough(run, width));
      candidates.back().over_foot = candidates.back().height - end;
    }
    run.clear();
  };
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (!run.empty() && isStep(run.back(), bins[i], scales.reach)) {
      const bool stray = i + 1 < bins.size() && !isStep(run.back(), bins[i + 1], scales.reach);
      if (stray) continue;
      close();
    }
    run.push_back(bins[i]);
  }
  close();
  return candidates;
}

}  // namespace tank_datum
