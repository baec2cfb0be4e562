#include "search/bucket_tree.h"

#include <algorithm>
#include <limits>

#include "core/parallel.h"
#include "search/bucket_walk.h"

namespace tank_datum {
namespace {

constexpr std::size_t kBucket = 16;                        // points at most
constexpr std::size_t kTaskPoints = std::size_t{1} << 15;  // fewer are not worth another thread

}  // namespace

float squaredDistanceOf(FoundPoint found) {
  const auto bits = static_cast<std::uint32_t>(found >> 32);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::int32_t numberOf(FoundPoint found) { return static_cast<std::int32_t>(found & 0xffffffffU); }

BucketTree::BucketTree(const std::vector<Eigen::Vector3f>& points, int threads)
    : x_(points.size()), y_(points.size()), z_(points.size()), ids_(points.size()) {
  while (points.size() > kBucket << depth_) ++depth_;
  boxes_.resize(2 * buckets());
  std::vector<Row> rows(points.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = {{points[i].x(), points[i].y(), points[i].z()}, static_cast<std::uint32_t>(i)};
  }
  std::size_t level = 0;
  for (; level < depth_ && points.size() >> level > kTaskPoints; ++level) {
    forEachIndex(std::size_t{1} << level, threads, [&](std::size_t node) { split(rows, level, node); });
  }
  forEachIndex(std::size_t{1} << level, threads, [&](std::size_t node) { build(rows, level, node); });
}

void BucketTree::build(std::vector<Row>& rows, std::size_t level, std::size_t node) {
  split(rows, level, node);
  if (level == depth_) return;
  build(rows, level + 1, 2 * node);
  build(rows, level + 1, 2 * node + 1);
}

/// Boxes the node's points and parts them at the median of their longest extent. Each node has its rows to itself.
void BucketTree::split(std::vector<Row>& rows, std::size_t level, std::size_t node) {
  const std::size_t begin = firstOf(level, node), end = firstOf(level, node + 1);
  constexpr float kFar = std::numeric_limits<float>::infinity();
  Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  for (std::size_t i = begin; i < end; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], rows[i].xyz[axis]);
      box.high[axis] = std::max(box.high[axis], rows[i].xyz[axis]);
    }
  }
  boxes_[(std::size_t{1} << level) + node] = box;
  if (level == depth_) {
    for (std::size_t i = begin; i < end; ++i) {
      x_[i] = rows[i].xyz[0];
      y_[i] = rows[i].xyz[1];
      z_[i] = rows[i].xyz[2];
      ids_[i] = rows[i].id;
    }
    return;
  }
  int axis = 0;
  for (const int other : {1, 2}) {
    if (box.high[other] - box.low[other] > box.high[axis] - box.low[axis]) axis = other;
  }
  const auto at = [&](std::size_t i) { return rows.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(firstOf(level + 1, 2 * node + 1)), at(end),
                   [axis](const Row& a, const Row& b) { return a.xyz[axis] < b.xyz[axis]; });
}

std::vector<FoundPoint> BucketTree::nearest(const Eigen::Vector3f& place, std::size_t k) const {
  std::vector<FoundPoint> kept;
  k = std::min(k, size());
  if (k == 0) return kept;
  kept.reserve(k);
  float reach = std::numeric_limits<float>::infinity();
  forEachBucket(place, reach, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FoundPoint candidate = found(place, i);
      if (kept.size() == k) {
        if (candidate > kept.back()) continue;
        kept.pop_back();
      }
      kept.insert(std::upper_bound(kept.begin(), kept.end(), candidate), candidate);
    }
    if (kept.size() == k) reach = squaredDistanceOf(kept.back());
  });
  return kept;
}

std::vector<FoundPoint> BucketTree::within(const Eigen::Vector3f& place, float squared_radius) const {
  std::vector<FoundPoint> kept;
  if (size() == 0) return kept;
  forEachBucket(place, squared_radius, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const FoundPoint candidate = found(place, i);
      if (squaredDistanceOf(candidate) <= squared_radius) kept.push_back(candidate);
    }
  });
  return kept;
}

}  // namespace tank_datum
