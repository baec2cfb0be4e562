#include "tank_datum/voxel_sample.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "point_hash.h"
#include "quick_floor.h"

namespace tank_datum {
namespace {

constexpr double kHalfRange = double(1 << 20) - 1;  // voxels on each side of the origin that 21 bits can number

constexpr std::size_t kFewestSlots = std::size_t(1) << 12;
constexpr std::size_t kAhead = 32;  // points whose slots are fetched before the first of them is put in

}  // namespace

VoxelSample::VoxelSample(std::size_t max_points, double voxel)
    : max_points_(max_points), voxel_(voxel), slots_(kFewestSlots) {}

std::int64_t VoxelSample::keyOf(const Eigen::Vector3d& point) const {
  std::int64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double place = point[axis] / voxel_;
    if (!(std::abs(place) < kHalfRange)) return kEmpty;
    const double index = quickFloor(place);
    key = (key << 21) | (static_cast<std::int64_t>(index) + (1 << 20));
  }
  return key;
}

void VoxelSample::insert(const Slot& slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = mixed(static_cast<std::uint64_t>(slot.key)) & mask;
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
  std::vector<Slot> held;
  held.reserve(used_);
  for (const Slot& slot : slots_) {
    if (slot.key == kEmpty) continue;
    held.push_back(slot);
    held.back().key = keyOf(slot.point);
  }
  slots_.assign(slots, Slot());
  used_ = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (i + kAhead < held.size()) prefetch(held[i + kAhead].key);
    insert(held[i]);
  }
}

void VoxelSample::coarsen() {
  voxel_ *= 2.0;
  std::size_t slots = slots_.size();
  while (slots > kFewestSlots && 4 * used_ <= slots) slots /= 2;
  rebuild(slots);
}

void VoxelSample::prefetch(std::int64_t key) const {
  __builtin_prefetch(&slots_[mixed(static_cast<std::uint64_t>(key)) & (slots_.size() - 1)], 1);
}

void VoxelSample::add(const Points& block) {
  std::array<Slot, kAhead> next;
  for (std::size_t begin = 0; begin < block.size(); begin += kAhead) {
    const std::size_t count = std::min(kAhead, block.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      Slot& slot = next[i];
      slot.point = block[begin + i];
      slot.rank = pointHash(slot.point);
      slot.count = 1;
      slot.key = keyOf(slot.point);
      prefetch(slot.key);
    }
    for (std::size_t i = 0; i < count; ++i) addOne(next[i]);
  }
}

void VoxelSample::addOne(Slot slot) {
  while ((slot.key = keyOf(slot.point)) == kEmpty) coarsen();  // voxels may have grown since it was fetched
  insert(slot);
  while (used_ > max_points_) coarsen();
  if (2 * used_ > slots_.size()) rebuild(4 * slots_.size());
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
