#include "search/neighbour_rows.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <atomic>
#include <future>

#include "search/spatial_order.h"
#include "tank_datum/core/parallel.h"

namespace tank_datum {
namespace {

/// Calls work(begin, end) for the parts of 0 .. count - 1, in plain threads: FLANN opens a parallel region for every
/// query, which inside of another region means a new team, allocated and locked, each time.
template <typename Work>
void forEachPart(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t kPart = 1024;
  std::atomic<std::size_t> next{0};
  const auto take_parts = [&] {
    for (std::size_t begin; (begin = next.fetch_add(kPart)) < count;) work(begin, std::min(begin + kPart, count));
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threadCount(threads); ++i) others.push_back(std::async(std::launch::async, take_parts));
  take_parts();
  for (auto& other : others) other.get();
}

void findWithFlann(const Points& points, const NeighbourRows& rows, const BucketTree::RowsDone& done) {
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<std::uint32_t> order;
  forEachIndex(2, rows.threads, [&](std::size_t task) {
    if (task == 1) {
      order = mortonOrder(points);
      return;
    }
    cloud->reserve(points.size());
    for (const auto& p : points) {
      cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
    }
    tree.setInputCloud(cloud);
  });
  const auto k = static_cast<std::size_t>(rows.k);
  forEachPart(points.size(), rows.threads, [&](std::size_t begin, std::size_t end) {
    pcl::Indices found(k);
    std::vector<float> squared_distances(k);
    for (std::size_t query = begin; query < end; ++query) {
      const std::uint32_t i = order[query];
      tree.nearestKSearch((*cloud)[i], rows.k, found, squared_distances);
      std::copy(found.begin(), found.end(), rows.first + i * k);
    }
    done(&order[begin], end - begin);
  });
}

void findWithBuckets(const Points& points, const NeighbourRows& rows, const BucketTree::RowsDone& done) {
  std::vector<Eigen::Vector3f> rounded(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) rounded[i] = points[i].cast<float>();
  const BucketTree tree(rounded, rows.threads);
  tree.nearestOfAll(static_cast<std::size_t>(rows.k), rows.threads, rows.first, done);
}

}  // namespace

void findRows(SearchEngine engine, const Points& points, const NeighbourRows& rows, const BucketTree::RowsDone& done) {
  switch (engine) {
    case SearchEngine::Flann:
      return findWithFlann(points, rows, done);
    case SearchEngine::Buckets:
      return findWithBuckets(points, rows, done);
  }
}

}  // namespace tank_datum
