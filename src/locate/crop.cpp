#include "locate/crop.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/point_hash.h"
#include "core/units.h"
#include "locate/keep_points.h"
#include "locate/ring_shape.h"
#include "locate/stray_points.h"
#include "search/voxel_sample.h"

namespace tank_datum {
namespace {

/// Numbers setups as they come. Points of one setup come together, so that the last one is asked first.
class SetupNumbers {
 public:
  std::uint16_t of(SetupKey key) {
    if (last_ < setups_.size() && setups_[last_] == key) return static_cast<std::uint16_t>(last_);
    const auto found = std::find(setups_.begin(), setups_.end(), key);
    last_ = static_cast<std::size_t>(found - setups_.begin());
    if (found == setups_.end() && setups_.size() <= kMostSetups) setups_.push_back(key);
    return static_cast<std::uint16_t>(last_);
  }
  std::vector<SetupKey> take() { return std::move(setups_); }

 private:
  std::vector<SetupKey> setups_;  // one more than the most says that there are too many
  std::size_t last_ = 0;
};

/// A growing set of points that keeps those of the lower hashes whenever it would grow beyond its bound.
class EvenShare {
 public:
  /// @param tells_setups  whether the points' setups are to be kept with them
  EvenShare(std::size_t most, bool tells_setups) : most_(most), tells_setups_(tells_setups) {}

  /// Whether a point would be kept so far; may be asked from several threads while one adds.
  bool wants(const Eigen::Vector3d& point) const { return pointHash(point) < limit_.load(std::memory_order_relaxed); }

  void add(const Eigen::Vector3d& point, std::uint16_t setup) {
    if (!wants(point)) return;
    kept_.push_back(point);
    if (tells_setups_) setups_.push_back(setup);
    while (kept_.size() > most_) {
      limit_.store(limit_.load(std::memory_order_relaxed) / 2, std::memory_order_relaxed);
      drop();
    }
  }
  Points takePoints() { return std::move(kept_); }
  std::vector<std::uint16_t> takeSetups() { return std::move(setups_); }

 private:
  void drop() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (!wants(kept_[i])) continue;
      kept_[kept] = kept_[i];
      if (tells_setups_) setups_[kept] = setups_[i];
      ++kept;
    }
    kept_.resize(kept);
    if (tells_setups_) setups_.resize(kept);
  }

  std::size_t most_;
  bool tells_setups_;
  std::atomic<std::uint64_t> limit_{std::uint64_t{1} << 32};
  Points kept_;
  std::vector<std::uint16_t> setups_;
};

}  // namespace

namespace {

/// Counts rows that cannot be of the tank, from several threads.
class FarRows {
 public:
  FarRows(const Tank& tank, const Eigen::Vector3d& zero)
      : centre_(tank.circle.center.x(), tank.circle.center.y(), tank.foot.coefficients[0]),
        furthest_(kRadii * tank.circle.radius),
        zero_(zero) {}

  void look(const Points& points) {
    const auto is_far = [this](const Eigen::Vector3d& p) {
      return !((p - centre_).cwiseAbs().maxCoeff() <= furthest_) || p == zero_;
    };
    count_ += static_cast<std::uint64_t>(std::count_if(points.begin(), points.end(), is_far));
  }
  std::uint64_t count() const { return count_; }

 private:
  static constexpr double kRadii = 100.0;
  Eigen::Vector3d centre_;
  double furthest_;
  Eigen::Vector3d zero_;
  std::atomic<std::uint64_t> count_{0};
};

void dropStrays(Ring& ring, const Tank& tank, int threads) {
  const double finest = 1e-4 * tank.circle.radius;
  const VoxelSample sample(ring.points, 8, finest, threads);  // asked how points are alone, not for its voxels
  if (!holdsStrays(sample)) return;
  const std::vector<char> is_stray = findStrays(ring.points, closingEdge(sample));
  keepPoints(ring, [&](std::size_t i) { return !is_stray[i]; });
}

}  // namespace

double widestReach(const Tank& tank, const CropOptions& options) {
  return reachOf(tank, options.reach) + 2.0 * tank.resolution;
}

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
  ring.reach = reachOf(tank, options.reach);
  const double reach = widestReach(tank, options);
  const RingShape shape(tank, reach);
  EvenShare share(options.fit_points, scan.tellsSetups());
  SetupNumbers numbers;
  FarRows far(tank, -scan.origin());
  const auto choose = [&](std::uint64_t block, const Points& points, Points& chosen) {
    if (also) also(block, points);
    far.look(points);
    for (const auto& p : points) {
      if (shape.holds(p) && share.wants(p)) chosen.push_back(p);
    }
  };
  const auto keep = [&](const Points& chosen, SetupKey setup) {
    const std::uint16_t number = numbers.of(setup);
    for (const auto& p : chosen) share.add(p, number);
  };
  ring.counts = scan.forEachChosen(choose, threads, keep, rowStride(scan, tank, options));
  ring.counts.far = far.count();
  ring.points = share.takePoints();
  ring.setups = numbers.take();
  if (ring.setups.size() > 1 && ring.setups.size() <= kMostSetups) ring.point_setups = share.takeSetups();
  if (tank.strays) dropStrays(ring, tank, threads);
  if (ring.point_setups.empty()) thinForSearch(ring, tank, options, threads);
  return ring;
}

void thinForSearch(Ring& ring, const Tank& tank, const CropOptions& options, int threads) {
  if (ring.points.size() <= options.search_points) {
    ring.search = ring.points;
    return;
  }
  // surfaces fill one layer of voxels: twice the ring's width all round is the area to spread the points over
  const double area = 2.0 * kTwoPi * tank.circle.radius * 2.0 * widestReach(tank, options);
  const double smallest = 0.5 * std::sqrt(area / static_cast<double>(options.search_points));
  ring.search = VoxelSample(ring.points, options.search_points, smallest, threads).points();
}

}  // namespace tank_datum
