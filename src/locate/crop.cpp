#include "tank_datum/locate/crop.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "core/point_hash.h"
#include "core/units.h"
#include "locate/ring_shape.h"
#include "locate/stray_points.h"
#include "search/voxel_sample.h"

namespace tank_datum {

std::string firstError(const CropOptions& options) {
  char text[80] = "";
  if (!(options.reach > 0.0 && std::isfinite(options.reach))) {
    std::snprintf(text, sizeof text, "crop.reach = %g m (must be > 0)", options.reach);
  } else if (options.search_points < 1000) {
    std::snprintf(text, sizeof text, "crop.search_points = %zu (must be >= 1000)", options.search_points);
  } else if (options.fit_points < 1000) {
    std::snprintf(text, sizeof text, "crop.fit_points = %zu (must be >= 1000)", options.fit_points);
  }
  return text;
}

namespace {

/// A growing set of points that keeps those of the lower hashes whenever it would grow beyond its bound.
class EvenShare {
 public:
  explicit EvenShare(std::size_t most) : most_(most) {}

  /// Whether a point would be kept so far.
  bool wants(const Eigen::Vector3d& point) const { return pointHash(point) < limit_; }

  void add(const Eigen::Vector3d& point) {
    if (!wants(point)) return;
    kept_.push_back(point);
    while (kept_.size() > most_) {
      limit_ /= 2;
      kept_.erase(std::remove_if(kept_.begin(), kept_.end(), [&](const auto& p) { return !wants(p); }), kept_.end());
    }
  }
  Points take() { return std::move(kept_); }

 private:
  std::size_t most_;
  std::uint64_t limit_ = std::uint64_t{1} << 32;
  Points kept_;
};

}  // namespace

namespace {

double reachOf(const Tank& tank, const CropOptions& options) {
  return std::min(options.reach, 0.5 * tank.circle.radius);
}

/// Enlarged by the accuracy of the coarse figures.
double widestReach(const Tank& tank, const CropOptions& options) {
  return reachOf(tank, options) + 2.0 * tank.resolution;
}

}  // namespace

std::uint64_t rowStride(const Scan& scan, const Tank& tank, const CropOptions& options) {
  constexpr double kWorthIt = 2.5;  // times what is kept; of less, all rows are looked at
  const double share = widestReach(tank, options) / Tank::kNear * tank.near_foot;
  const double times = share * static_cast<double>(scan.size()) / static_cast<double>(options.fit_points);
  if (times < kWorthIt) return 1;
  const std::uint64_t most = std::max<std::uint64_t>(1, scan.size() / kPointsLookedAt);
  return std::min(most, static_cast<std::uint64_t>(std::ceil(times))) | 1U;
}

Ring cropRing(const Scan& scan, const Tank& tank, const CropOptions& options, const AlsoGathered& also, int threads) {
  Ring ring;
  ring.reach = reachOf(tank, options);
  const double reach = widestReach(tank, options);
  const RingShape shape(tank, reach);
  EvenShare share(options.fit_points);
  const auto choose = [&](std::uint64_t block, const Points& points, Points& chosen) {
    thread_local std::vector<char> wanted;
    wanted.assign(points.size(), 0);
    if (also.mark) also.mark(block, points, wanted);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (wanted[i] || (shape.holds(points[i]) && share.wants(points[i]))) chosen.push_back(points[i]);
    }
  };
  const auto keep = [&](const Points& chosen) {
    if (also.add) also.add(chosen);
    for (const auto& p : chosen) {
      if (shape.holds(p)) share.add(p);
    }
  };
  ring.counts = scan.forEachChosen(choose, threads, keep, rowStride(scan, tank, options));
  ring.points = share.take();
  if (tank.strays) {
    const double finest = 1e-4 * tank.circle.radius;
    const VoxelSample sample(ring.points, std::max<std::size_t>(8, ring.points.size()), finest, threads);
    if (holdsStrays(sample)) ring.points = withoutStrays(ring.points, closingEdge(sample));
  }
  if (ring.points.size() <= options.search_points) {
    ring.search = ring.points;
    return ring;
  }
  // surfaces fill one layer of voxels: twice the ring's width all round is the area to spread the points over
  const double area = 2.0 * kTwoPi * tank.circle.radius * 2.0 * reach;
  const double smallest = 0.5 * std::sqrt(area / static_cast<double>(options.search_points));
  ring.search = VoxelSample(ring.points, options.search_points, smallest, threads).points();
  return ring;
}

}  // namespace tank_datum
