#include "tank_datum/pcl/bucket_search.h"

#include <algorithm>

#include "search/bucket_tree.h"

namespace tank_datum {
namespace {

BucketAnswer answerOf(const std::vector<FoundPoint>& found, const pcl::Indices& held) {
  BucketAnswer answer;
  for (const FoundPoint point : found) {
    answer.indices.push_back(held[static_cast<std::size_t>(numberOf(point))]);
    answer.squared_distances.push_back(squaredDistanceOf(point));
  }
  return answer;
}

}  // namespace

BucketIndex::BucketIndex(const std::vector<Eigen::Vector3f>& places, pcl::Indices held)
    : tree_(std::make_shared<const BucketTree>(places)), held_(std::move(held)) {}

BucketAnswer BucketIndex::nearest(const Eigen::Vector3f& place, int k) const {
  return answerOf(tree_->nearest(place, static_cast<std::size_t>(std::max(0, k))), held_);
}

BucketAnswer BucketIndex::within(const Eigen::Vector3f& place, double radius, bool sorted, unsigned int most) const {
  std::vector<FoundPoint> found = tree_->within(place, static_cast<float>(radius * radius));
  if (sorted || most != 0) std::sort(found.begin(), found.end());
  if (most != 0 && found.size() > most) found.resize(most);
  return answerOf(found, held_);
}

}  // namespace tank_datum
