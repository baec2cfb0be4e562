#include "locate/sample_ladder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "io/point_extent.h"
#include "locate/stray_points.h"
#include "search/voxel_sample.h"

namespace tank_datum {

std::uint64_t strideOf(std::uint64_t points) {
  constexpr std::uint64_t kLookedAt = 2'000'000;
  return points / kLookedAt | 1U;
}

Points lookAt(const Scan& scan, int threads) {
  Points points = scan.everyNth(strideOf(scan.size()), threads);
  dropNoReturns(points, -scan.origin());
  return points;
}

double finestVoxel(const Points& points, int threads) {
  constexpr double kRung = 0.008;                 // of this and of its halves and doubles are the edges [m]
  constexpr double kHalfRange = double(1 << 19);  // voxels
  const double reach = std::max(1e-9, largestCoordinate(points, threads));
  return kRung * portable::exp2(std::ceil(portable::log2(reach / kHalfRange / kRung)));
}

namespace {

/// @param sample  of points, in the finest voxels
std::vector<Sample> ladderOf(VoxelSample sample, bool strays, double coarsest) {
  std::vector<Sample> samples;
  for (; sample.size() > 50; sample.coarsen()) {
    const double share = sample.shareHolding(2);
    // where most voxels hold several points, one that holds a single one is a stray beam
    if (share >= 0.1) samples.push_back({sample.points(share >= 0.5 ? 2 : 1), sample.voxel(), strays});
    if (samples.size() >= 3 && sample.voxel() > coarsest) break;
  }
  return samples;
}

double coarsestVoxel(const Points& looked_at, const LocateOptions& options) {
  constexpr double kSmallPart = 1.0 / 60.0;  // of the scan's reach: tanks fill a good part of their scan
  return std::max(0.25 * options.min_radius, kSmallPart * extentOf(looked_at).reach);
}

}  // namespace

std::vector<Sample> samplesOf(const Points& looked_at, const LocateOptions& options, int threads) {
  if (looked_at.empty()) return {};
  const double finest = finestVoxel(looked_at, threads);
  VoxelSample sample(looked_at, options.sample_points, finest, threads);
  const bool strays = holdsStrays(sample);
  if (strays)
    sample = VoxelSample(withoutStrays(looked_at, closingEdge(sample)), options.sample_points, finest, threads);
  return ladderOf(std::move(sample), strays, coarsestVoxel(looked_at, options));
}

std::vector<Sample> samplesOfAll(const Points& looked_at, const LocateOptions& options, int threads) {
  if (looked_at.empty()) return {};
  VoxelSample sample(looked_at, options.sample_points, finestVoxel(looked_at, threads), threads);
  return ladderOf(std::move(sample), false, coarsestVoxel(looked_at, options));
}

}  // namespace tank_datum
