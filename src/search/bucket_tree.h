#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace tank_datum {

/// A point met by a search: its squared distance and its number in one integer, which sorts by distance, then by
/// number.
using FoundPoint = std::uint64_t;

float squaredDistanceOf(FoundPoint found);
std::int32_t numberOf(FoundPoint found);

/// A kd-tree whose leaves are buckets of at most 16 points, one after the other in memory (Friedman, Bentley and Finkel
/// 1977). It is there for the k nearest of all of its own points at once: those of a bucket have nearly the same
/// neighbours, so what lies around them is gathered for all of them together.
///
/// Distances are those of pcl::KdTreeFLANN to the last bit: float32, (dx dx + dy dy) + dz dz. Of points equally far the
/// one of the lower number comes first, where FLANN takes them as its tree has them. Nothing depends on the number of
/// threads.
class BucketTree {
 public:
  /// @param points   finite, fewer than 2^31 [m]; copied
  /// @param threads  0 means all cores
  explicit BucketTree(const std::vector<Eigen::Vector3f>& points, int threads = 0);

  std::size_t size() const { return ids_.size(); }

  /// The k points nearest to a place, nearest first; all points if there are not so many.
  std::vector<FoundPoint> nearest(const Eigen::Vector3f& place, std::size_t k) const;

  /// The points at most so far from a place, in no order.
  std::vector<FoundPoint> within(const Eigen::Vector3f& place, float squared_radius) const;

  /// Told, from several threads, whose rows are filled.
  using RowsDone = std::function<void(const std::uint32_t* points, std::size_t count)>;

  /// The k nearest of every point, itself included unless k others lie in the same place.
  /// @param k     at most size()
  /// @param rows  size() rows of k point numbers, nearest first
  void nearestOfAll(std::size_t k, int threads, std::int32_t* rows, const RowsDone& done = {}) const;

 private:
  struct Box {
    float low[3], high[3];
  };
  struct Row {
    float xyz[3];
    std::uint32_t id;
  };
  struct Batch;

  std::size_t buckets() const { return std::size_t{1} << depth_; }
  std::size_t firstOf(std::size_t level, std::size_t node) const { return (size() * node) >> level; }
  const Box& boxOf(std::size_t level, std::size_t node) const { return boxes_[(std::size_t{1} << level) + node]; }
  FoundPoint found(const Eigen::Vector3f& place, std::size_t at) const;
  static float squaredGap(const Box& box, const Eigen::Vector3f& place);
  static float squaredGap(const Box& a, const Box& b);
  void build(std::vector<Row>& rows, std::size_t level, std::size_t node);
  void split(std::vector<Row>& rows, std::size_t level, std::size_t node);
  template <typename From, typename Visit>
  void forEachBucket(const From& from, const float& squared_reach, const Visit& visit) const;
  void gather(std::size_t bucket, float squared_reach, Batch& batch) const;
  bool nearestInBatch(const Eigen::Vector3f& place, std::size_t k, Batch& batch) const;
  void fillBucket(std::size_t bucket, std::size_t k, std::int32_t* rows, Batch& batch) const;

  std::size_t depth_ = 0;         // every bucket is so far below the root
  std::vector<Box> boxes_;        // of node n of level l at 2^l + n
  std::vector<float> x_, y_, z_;  // bucket by bucket
  std::vector<std::uint32_t> ids_;
};

}  // namespace tank_datum
