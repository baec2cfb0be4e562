#pragma once

#include <pcl/search/search.h>
#include <pcl/types.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/search/bucket_tree.h"

namespace TANK_DATUM_API tank_datum {

/// BucketTree wherever PCL takes a search: DatumFilter::setSearchMethod, pcl::NormalEstimation and others. Points of
/// the cloud that are not finite are not found, as in PCL's own searches. Asked for one point at a time it is about as
/// fast as pcl::search::KdTree; what makes the engine "buckets" fast is that it asks for all points at once.
template <typename PointT>
class BucketSearch : public pcl::search::Search<PointT> {
 public:
  using Base = pcl::search::Search<PointT>;
  using PointCloudConstPtr = typename Base::PointCloudConstPtr;
  using IndicesConstPtr = typename Base::IndicesConstPtr;
  using Ptr = std::shared_ptr<BucketSearch<PointT>>;

  /// @param sorted  nearest first in the answers of radiusSearch too
  explicit BucketSearch(bool sorted = true) : Base("BucketSearch", sorted), tree_({}) {}

  void setInputCloud(const PointCloudConstPtr& cloud, const IndicesConstPtr& indices = {}) override {
    this->input_ = cloud;
    this->indices_ = indices;
    held_.clear();
    std::vector<Eigen::Vector3f> places;
    const std::size_t count = indices ? indices->size() : cloud->size();
    for (std::size_t i = 0; i < count; ++i) {
      const pcl::index_t at = indices ? (*indices)[i] : static_cast<pcl::index_t>(i);
      const auto place = (*cloud)[static_cast<std::size_t>(at)].getVector3fMap();
      if (!place.allFinite()) continue;
      places.push_back(place);
      held_.push_back(at);
    }
    tree_ = BucketTree(places);
  }

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /// @return how many were found: k, or all points if there are not so many
  int nearestKSearch(const PointT& point, int k, pcl::Indices& k_indices,
                     std::vector<float>& k_sqr_distances) const override {
    return tell(tree_.nearest(point.getVector3fMap(), static_cast<std::size_t>(std::max(0, k))), k_indices,
                k_sqr_distances);
  }

  /// @param max_nn  the nearest so many at most; 0: all
  int radiusSearch(const PointT& point, double radius, pcl::Indices& k_indices, std::vector<float>& k_sqr_distances,
                   unsigned int max_nn = 0) const override {
    std::vector<FoundPoint> found = tree_.within(point.getVector3fMap(), static_cast<float>(radius * radius));
    if (this->sorted_results_ || max_nn != 0) std::sort(found.begin(), found.end());
    if (max_nn != 0 && found.size() > max_nn) found.resize(max_nn);
    return tell(found, k_indices, k_sqr_distances);
  }

 private:
  int tell(const std::vector<FoundPoint>& found, pcl::Indices& indices, std::vector<float>& squared_distances) const {
    indices.clear();
    squared_distances.clear();
    for (const FoundPoint point : found) {
      indices.push_back(held_[static_cast<std::size_t>(numberOf(point))]);
      squared_distances.push_back(squaredDistanceOf(point));
    }
    return static_cast<int>(found.size());
  }

  BucketTree tree_;
  pcl::Indices held_;  // of the tree's points in the cloud
};

}  // namespace tank_datum
