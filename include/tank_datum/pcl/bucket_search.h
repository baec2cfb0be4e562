#pragma once

#include <pcl/search/search.h>
#include <pcl/types.h>

#include <memory>
#include <utility>
#include <vector>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

class BucketTree;

/// What a search found: numbers in the cloud and squared distances.
struct BucketAnswer {
  pcl::Indices indices;
  std::vector<float> squared_distances;
};

/// Points in a kd-tree of buckets, and which of a cloud's they are; what BucketSearch asks.
class BucketIndex {
 public:
  /// @param places  finite [m]
  /// @param held    the number of each of them in the cloud
  BucketIndex(const std::vector<Eigen::Vector3f>& places, pcl::Indices held);

  /// The k points nearest to a place, nearest first; all points if there are not so many.
  BucketAnswer nearest(const Eigen::Vector3f& place, int k) const;

  /// The points at most so far from a place [m].
  /// @param most  the nearest so many at most; 0: all
  BucketAnswer within(const Eigen::Vector3f& place, double radius, bool sorted, unsigned int most) const;

 private:
  std::shared_ptr<const BucketTree> tree_;
  pcl::Indices held_;
};

/// A kd-tree of buckets wherever PCL takes a search: DatumFilter::setSearchMethod, pcl::NormalEstimation and others.
/// Points of the cloud that are not finite are not found, as in PCL's own searches. Asked for one point at a time it is
/// about as fast as pcl::search::KdTree; what makes the engine "buckets" fast is that it asks for all points at once.
template <typename PointT>
class BucketSearch : public pcl::search::Search<PointT> {
 public:
  using Base = pcl::search::Search<PointT>;
  using PointCloudConstPtr = typename Base::PointCloudConstPtr;
  using IndicesConstPtr = typename Base::IndicesConstPtr;
  using Ptr = std::shared_ptr<BucketSearch<PointT>>;

  /// @param sorted  nearest first in the answers of radiusSearch too
  explicit BucketSearch(bool sorted = true) : Base("BucketSearch", sorted), buckets_({}, {}) {}

  void setInputCloud(const PointCloudConstPtr& cloud, const IndicesConstPtr& indices = {}) override {
    this->input_ = cloud;
    this->indices_ = indices;
    std::vector<Eigen::Vector3f> places;
    pcl::Indices held;
    const std::size_t count = indices ? indices->size() : cloud->size();
    for (std::size_t i = 0; i < count; ++i) {
      const pcl::index_t at = indices ? (*indices)[i] : static_cast<pcl::index_t>(i);
      const auto place = (*cloud)[static_cast<std::size_t>(at)].getVector3fMap();
      if (!place.allFinite()) continue;
      places.push_back(place);
      held.push_back(at);
    }
    buckets_ = BucketIndex(places, std::move(held));
  }

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /// @return how many were found: k, or all points if there are not so many
  int nearestKSearch(const PointT& point, int k, pcl::Indices& k_indices,
                     std::vector<float>& k_sqr_distances) const override {
    return tell(buckets_.nearest(point.getVector3fMap(), k), k_indices, k_sqr_distances);
  }

  /// @param max_nn  the nearest so many at most; 0: all
  int radiusSearch(const PointT& point, double radius, pcl::Indices& k_indices, std::vector<float>& k_sqr_distances,
                   unsigned int max_nn = 0) const override {
    return tell(buckets_.within(point.getVector3fMap(), radius, this->sorted_results_, max_nn), k_indices,
                k_sqr_distances);
  }

 private:
  static int tell(BucketAnswer found, pcl::Indices& indices, std::vector<float>& squared_distances) {
    indices = std::move(found.indices);
    squared_distances = std::move(found.squared_distances);
    return static_cast<int>(indices.size());
  }

  BucketIndex buckets_;
};

}  // namespace tank_datum
