#pragma once

#include <cstdint>
#include <vector>

#include "tank_datum/export.h"
#include "tank_datum/scan.h"

namespace TANK_DATUM_API tank_datum {

/// A thinned copy of a scan in bounded memory: one point per voxel, and voxels grown by doubling until they fit the
/// bound.
///
/// Which point stands for its voxel is decided by a hash of its coordinates, so the sample does not depend on the
/// order of the points.
class VoxelSample {
 public:
  /// @param max_points  the most voxels kept; at least 8, since the octants about the origin never merge
  /// @param voxel       edge to start from [m]; a scanner's spacing is not finer than 1 mm on anything it measures well
  explicit VoxelSample(std::size_t max_points, double voxel = 0.001);

  void add(const Points& block);

  /// Doubles the voxels once.
  void coarsen();

  /// Share of the voxels that hold at least `count` points of the scan.
  double shareHolding(std::uint32_t count) const;

  /// One point of every voxel that holds at least `count` points of the scan, sorted by x, y, z.
  Points points(std::uint32_t count = 1) const;
  /// Voxels that hold a point.
  std::size_t size() const { return used_; }

  /// Edge of a voxel [m].
  double voxel() const { return voxel_; }

 private:
  struct Slot {
    std::int64_t key = kEmpty;
    std::uint32_t rank = 0, count = 0;
    Eigen::Vector3d point;
  };
  static constexpr std::int64_t kEmpty = -1;

  std::int64_t keyOf(const Eigen::Vector3d& point) const;
  void insert(const Slot& slot);
  void addOne(Slot slot);
  void rebuild(std::size_t slots);
  void prefetch(std::int64_t key) const;

  std::size_t max_points_, used_ = 0;
  double voxel_;
  std::vector<Slot> slots_;
};

}  // namespace tank_datum
