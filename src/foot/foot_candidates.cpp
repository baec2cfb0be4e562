#include "foot/foot_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "foot/foot_profile.h"
#include "foot/lowest_layer.h"
#include "foot/section_stretches.h"

namespace tank_datum {
namespace {

constexpr double kSteepest = 0.1;  // of a foundation surface [m/m]

struct Bin {
  double d, z, spread, error;
  double from, to;
  std::size_t points;
};

/// The points of a section in order of d, and how far they are apart on the average [m].
struct SortedSection {
  std::vector<FootPoint> points;
  double spacing = 0;
};

SortedSection sorted(const std::vector<FootPoint>& points, double near, double reach) {
  SortedSection section;
  for (const FootPoint& p : points) {
    if (p.d >= near && p.d < reach) section.points.push_back(p);
  }
  std::sort(section.points.begin(), section.points.end(),
            [](const FootPoint& a, const FootPoint& b) { return a.d != b.d ? a.d < b.d : a.z < b.z; });
  section.spacing = (reach - near) / std::max(1.0, static_cast<double>(section.points.size()));
  return section;
}

/// Index after the last point of a bin that begins at `first`: eight points, no narrower than `width`, without a gap.
std::size_t endOfBin(const SortedSection& section, std::size_t first, double width) {
  constexpr std::size_t kPointsPerBin = 8;
  constexpr double kGap = 6.0;  // spacings: so far apart points of one surface are once in 400 times
  const std::vector<FootPoint>& points = section.points;
  std::size_t end = first + 1;
  while (end < points.size() && (end - first < kPointsPerBin || points[end].d - points[first].d < width)) {
    if (points[end].d - points[end - 1].d > std::max(width, kGap * section.spacing)) break;
    ++end;
  }
  return end;
}

/// Drops bins that hold far fewer points for their width than the others: a beam that grazes an edge leaves points
/// between what it meets, where there is no surface.
void dropThin(std::vector<Bin>& bins, double width) {
  constexpr double kThin = 0.4;  // of the usual density
  const auto density = [width](const Bin& bin) {
    return static_cast<double>(bin.points) / std::max(width, bin.to - bin.from);
  };
  std::vector<double> densities;
  for (const Bin& bin : bins) densities.push_back(density(bin));
  const double least = kThin * median(densities);
  bins.erase(std::remove_if(bins.begin(), bins.end(), [&](const Bin& bin) { return density(bin) < least; }),
             bins.end());
}

/// Bins that follow the points: narrow where there are many, none where there are none.
std::vector<Bin> binsOf(const std::vector<FootPoint>& points, const FootScales& scales, double near) {
  constexpr std::size_t kFewestOfLayer = 3;
  const double width = std::max(scales.reach / 50.0, scales.shell_noise);
  const double layer = std::max(0.02 * scales.reach, 6.0 * scales.shell_noise);
  const SortedSection section = sorted(points, near, scales.reach);
  std::vector<Bin> bins;
  std::vector<double> spreads;
  for (std::size_t first = 0, end = 0; first < section.points.size(); first = end) {
    end = endOfBin(section, first, width);
    std::vector<double> heights;
    double d = 0;
    for (std::size_t i = first; i < end; ++i) {
      heights.push_back(section.points[i].z);
      d += section.points[i].d / static_cast<double>(end - first);
    }
    keepLowestLayer(heights, layer);
    if (heights.size() < kFewestOfLayer) continue;
    const double z = median(heights), spread = robustSigma(heights, z);
    const double error = kMedianOverMean / std::sqrt(static_cast<double>(heights.size()));
    bins.push_back({d, z, spread, error, section.points[first].d, section.points[end - 1].d, heights.size()});
    spreads.push_back(spread);
  }
  const double typical = std::max(median(spreads), 1e-7);  // of few points a spread may be nought by chance
  for (Bin& bin : bins) bin.error *= std::max(bin.spread, typical);
  dropThin(bins, width);
  return bins;
}

bool isStep(const Bin& a, const Bin& b, double reach) {
  constexpr double kStep = 0.005;  // of the reach
  return std::abs(a.z - b.z) > kStep * reach + kSteepest * (b.d - a.d) + 3.0 * std::hypot(a.error, b.error);
}

/// The line through a run of bins: median of the slopes between its thirds, median of the offsets; of a few bins by
/// least squares.
FootCandidate stretchOf(const std::vector<Bin>& run) {
  constexpr std::size_t kFew = 4;
  std::vector<SectionBin> bins;
  std::vector<double> slopes, offsets, spreads;
  for (const Bin& bin : run) {
    bins.push_back({bin.d, bin.z, bin.error});
    spreads.push_back(bin.spread);
  }
  const SectionLine line = lineThrough(bins, {0, bins.size()}, kSteepest);
  FootCandidate stretch;
  stretch.slope = line.slope;
  stretch.height = line.at(0.0);
  if (run.size() >= kFew) {
    const std::size_t apart = std::max<std::size_t>(1, (run.size() - 1) / 3);
    for (std::size_t i = 0; i < run.size(); ++i) {
      for (std::size_t j = i + apart; j < run.size(); ++j)
        slopes.push_back((run[j].z - run[i].z) / (run[j].d - run[i].d));
    }
    stretch.slope = median(slopes);
    for (const Bin& bin : run) offsets.push_back(bin.z - stretch.slope * bin.d);
    stretch.height = median(offsets);
  }
  stretch.noise = median(spreads);
  stretch.sigma_slope = std::sqrt(line.variance_slope);
  stretch.error = std::sqrt(line.varianceAt(0.0));
  stretch.from = run.front().from;
  stretch.to = run.back().to;
  return stretch;
}

/// The parts of a run between its steps, in order, also of steps too small to be seen between neighbouring bins.
void addParts(const std::vector<Bin>& run, const FootScales& scales, std::vector<std::vector<Bin>>& parts) {
  constexpr double kStep = 0.005, kLength = 0.2;  // of the reach
  std::vector<SectionBin> bins;
  for (const Bin& bin : run) bins.push_back({bin.d, bin.z, bin.error});
  const std::size_t end = binsBeforeStep(bins, {kStep * scales.reach, 2.0 * scales.blur(), kLength * scales.reach});
  const auto middle = run.begin() + static_cast<std::ptrdiff_t>(end);
  parts.emplace_back(run.begin(), middle);
  if (middle != run.end()) addParts({middle, run.end()}, scales, parts);
}

/// How many points a metre lie at the bottom of some elevations, far below any foot, where those are far fewer than
/// above; else 0. A wet floor mirrors some beams to the shell: their points lie straight below it, as far down as it
/// stands up.
double mirroredIn(const std::vector<double>& z, double bottom, double reach) {
  constexpr double kDeep = 0.2;  // of the reach
  constexpr double kFew = 0.1;   // of the points a metre from there on
  const double deep = bottom + kDeep * reach;
  const auto below = static_cast<double>(std::count_if(z.begin(), z.end(), [&](double at) { return at < deep; }));
  if (below == 0.0) return 0.0;
  const double density = below / (kDeep * reach), top = *std::max_element(z.begin(), z.end());
  return density * (top - deep) < kFew * (static_cast<double>(z.size()) - below) ? density : 0.0;
}

/// The elevation that the shell is seen down to, but for stray points and its image.
/// @param bottom  from where on points were looked for
double endOfShell(const std::vector<FootPoint>& points, const FootScales& scales, double bottom) {
  constexpr std::size_t kStray = 2;
  constexpr double kUneven = 2.0;    // times as dense an image may be as at its bottom
  constexpr double kChance = 3.0;    // standard deviations of a number of points
  constexpr std::size_t kDense = 6;  // points of the shell, closer than so many of its image
  std::vector<double> z;
  for (const FootPoint& p : points) {
    if (std::abs(p.d) < 3.0 * scales.shell_noise) z.push_back(p.z);
  }
  std::size_t at = kStray + z.size() / 500;
  if (at >= z.size()) return std::numeric_limits<double>::quiet_NaN();
  const double mirrored = mirroredIn(z, bottom, scales.reach);
  if (mirrored == 0.0) {
    std::nth_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(at), z.end());
    return z[at];
  }
  std::sort(z.begin(), z.end());
  const auto isImage = [&](std::size_t index) {
    const double of_image = kUneven * mirrored * (z[index] - bottom);
    return static_cast<double>(index) < of_image + kChance * std::sqrt(of_image);
  };
  while (at + 1 < z.size() && isImage(at)) ++at;
  while (at > kDense && (z[at] - z[at - kDense]) * mirrored < 1.0) --at;  // which the image may be by its number alone
  return z[at];
}

}  // namespace

std::vector<FootCandidate> findCandidates(const std::vector<FootPoint>& points, const FootScales& scales,
                                          double bottom) {
  constexpr std::size_t kFewestPoints = 6;
  const double near = scales.nearest();
  const std::vector<Bin> bins = binsOf(points, scales, near);
  const double end = endOfShell(points, scales, bottom);
  std::vector<FootCandidate> candidates;
  std::vector<Bin> run;
  const auto close = [&] {
    std::vector<std::vector<Bin>> parts;
    if (!run.empty()) addParts(run, scales, parts);
    for (const std::vector<Bin>& part : parts) {
      std::size_t count = 0;
      for (const Bin& bin : part) count += bin.points;
      if (count < kFewestPoints) continue;
      candidates.push_back(stretchOf(part));
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
