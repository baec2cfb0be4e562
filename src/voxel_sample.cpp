#include "tank_datum/voxel_sample.h"

#include <algorithm>
#include <cmath>

namespace tank_datum {
namespace {

constexpr double kHalfRange = double(1 << 20) - 1;  // voxels on each side of the origin that 21 bits can number

std::uint64_t mix(std::uint64_t x) {  // finaliser of SplitMix64 (Steele et al. 2014)
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Of the coordinates in steps far above their rounding, so that the same tank in another frame has the same sample.
std::uint32_t rankOf(const Eigen::Vector3d& point) {
  constexpr double kStep = 1e-5;  // [m]
  const auto steps = [&](int axis) { return static_cast<std::uint64_t>(std::llround(point[axis] / kStep)); };
  return static_cast<std::uint32_t>(mix(steps(0) ^ mix(steps(1) ^ mix(steps(2)))));
}

}  // namespace

VoxelSample::VoxelSample(std::size_t max_points, double voxel)
    : max_points_(max_points), voxel_(voxel), slots_(std::size_t(1) << 12) {}

std::int64_t VoxelSample::keyOf(const Eigen::Vector3d& point) const {
  std::int64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double index = std::floor(point[axis] / voxel_);
    if (std::abs(index) > kHalfRange) return kEmpty;
    key = (key << 21) | (static_cast<std::int64_t>(index) + (1 << 20));
  }
  return key;
}

void VoxelSample::insert(const Slot& slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = mix(static_cast<std::uint64_t>(slot.key)) & mask;
  while (slots_[at].key != kEmpty && slots_[at].key != slot.key) at = (at + 1) & mask;
  Slot& held = slots_[at];
  if (held.key == kEmpty) {
    held = slot;
    ++used_;
    return;
  }
  held.count += slot.count;
  if (slot.rank < held.rank) {
    held.rank = slot.rank;
    held.point = slot.point;
  }
}

void VoxelSample::rebuild(std::size_t slots) {
  std::vector<Slot> old(slots);
  old.swap(slots_);
  used_ = 0;
  for (Slot& slot : old) {
    if (slot.key == kEmpty) continue;
    slot.key = keyOf(slot.point);
    insert(slot);
  }
}

void VoxelSample::coarsen() {
  voxel_ *= 2.0;
  rebuild(slots_.size());
}

void VoxelSample::add(const Points& block) {
  for (const auto& point : block) {
    Slot slot;
    slot.point = point;
    slot.rank = rankOf(point);
    slot.count = 1;
    while ((slot.key = keyOf(point)) == kEmpty) coarsen();
    insert(slot);
    while (used_ > max_points_) coarsen();
    if (2 * used_ > slots_.size()) rebuild(2 * slots_.size());
  }
}

double VoxelSample::shareHolding(std::uint32_t count) const {
  std::size_t holding = 0;
  for (const Slot& slot : slots_) holding += slot.key != kEmpty && slot.count >= count;
  return static_cast<double>(holding) / static_cast<double>(std::max<std::size_t>(1, used_));
}

Points VoxelSample::points(std::uint32_t count) const {
  Points result;
  result.reserve(used_);
  for (const Slot& slot : slots_) {
    if (slot.key != kEmpty && slot.count >= count) result.push_back(slot.point);
  }
  // slot order depends on the history of the table; sorted, the sample is the same for any order of arrival
  std::sort(result.begin(), result.end(), [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  return result;
}

}  // namespace tank_datum
