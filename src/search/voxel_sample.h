#pragma once

#include <cstdint>
#include <vector>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// The largest coordinate of any point along any axis, without its sign; 0 of none [m].
double largestCoordinate(const Points& points, int threads);

/// Points thinned evenly: one per voxel, in the smallest voxels, of those doubled again and again, that are few enough.
///
/// The points are sorted once along the Morton curve, on which the points of a voxel of any size follow one another.
/// Which of them stands for its voxel is decided by a hash of its coordinates, so the sample does not depend on the
/// order of the points.
class VoxelSample {
 public:
  /// @param points      fewer than 2^32 [m]
  /// @param max_points  the most voxels wanted; at least 8, since the octants about the origin never merge
  /// @param voxel       edge to start from [m]; a scanner's spacing is not finer than 1 mm on anything it measures well
  /// @param threads     0 means all cores
  VoxelSample(const Points& points, std::size_t max_points, double voxel = 0.001, int threads = 0);

  /// Doubles the voxels once.
  void coarsen();

  /// Share of the voxels that hold at least `count` points.
  double shareHolding(std::uint32_t count) const;

  /// Share of the points given that had a voxel of that edge to themselves [m]: surfaces close at some edge, what
  /// floats in the air at a much longer one.
  double shareAlone(double edge) const;

  /// The shortest edge, of those doubled again and again, at which at most this share of the points is alone [m].
  double edgeWithAlone(double share) const;

  /// One point of every voxel that holds at least `count` points, along the Morton curve.
  Points points(std::uint32_t count = 1) const;

  /// Voxels that hold a point.
  std::size_t size() const { return voxels_.size(); }

  /// Edge of a voxel [m].
  double voxel() const { return voxel_; }

 private:
  struct Voxel {
    std::uint64_t code;         ///< on the Morton curve
    std::uint32_t rank, count;  ///< hash of the point that stands for it, and points that it holds
    Eigen::Vector3d point;
  };

  double voxel_, finest_;  ///< of now, and of the smallest voxels [m]
  std::vector<Voxel> voxels_;
  std::vector<double> alone_;   ///< share of the points alone in their voxel, after so many doublings of the smallest
  std::size_t doublings_left_;  ///< after which there are the octants about the origin only
};

}  // namespace tank_datum
