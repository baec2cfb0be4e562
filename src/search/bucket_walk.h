#pragma once

#include <algorithm>
#include <array>
#include <cstring>

#include "search/bucket_tree.h"

namespace tank_datum {

inline FoundPoint foundPoint(float squared_distance, std::uint32_t number) {
  std::uint32_t bits = 0;  // floats that are not negative sort as their bits do
  std::memcpy(&bits, &squared_distance, sizeof bits);
  return std::uint64_t{bits} << 32 | number;
}

inline FoundPoint BucketTree::found(const Eigen::Vector3f& place, std::size_t at) const {
  const float dx = place.x() - x_[at], dy = place.y() - y_[at], dz = place.z() - z_[at];
  return foundPoint((dx * dx + dy * dy) + dz * dz, ids_[at]);
}

/// No more than the squared distance of any point of the box, rounding included: both are rounded in the same steps,
/// and rounding keeps order.
inline float BucketTree::squaredGap(const Box& box, const Eigen::Vector3f& place) {
  float gap[3];
  for (int axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({box.low[axis] - place[axis], place[axis] - box.high[axis], 0.0F});
  }
  return (gap[0] * gap[0] + gap[1] * gap[1]) + gap[2] * gap[2];
}

inline float BucketTree::squaredGap(const Box& a, const Box& b) {
  float gap[3];
  for (int axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({a.low[axis] - b.high[axis], b.low[axis] - a.high[axis], 0.0F});
  }
  return (gap[0] * gap[0] + gap[1] * gap[1]) + gap[2] * gap[2];
}

/// Calls visit(begin, end) for the buckets whose box is within reach of a place or a box, nearer halves first; visit
/// may shorten the reach.
template <typename From, typename Visit>
void BucketTree::forEachBucket(const From& from, const float& squared_reach, const Visit& visit) const {
  struct Step {
    std::size_t level, node;
    float gap;
  };
  std::array<Step, 64> stack;  // one of each level at most waits for its sibling
  std::size_t waiting = 0;
  stack[waiting++] = {0, 0, squaredGap(boxOf(0, 0), from)};
  while (waiting > 0) {
    const Step step = stack[--waiting];
    if (step.gap > squared_reach) continue;
    if (step.level == depth_) {
      visit(firstOf(depth_, step.node), firstOf(depth_, step.node + 1));
      continue;
    }
    Step near{step.level + 1, 2 * step.node, 0}, far{step.level + 1, 2 * step.node + 1, 0};
    near.gap = squaredGap(boxOf(near.level, near.node), from);
    far.gap = squaredGap(boxOf(far.level, far.node), from);
    if (far.gap < near.gap) std::swap(near, far);
    if (far.gap <= squared_reach) stack[waiting++] = far;
    if (near.gap <= squared_reach) stack[waiting++] = near;
  }
}

}  // namespace tank_datum
