#include "neighbour_rows.h"

#include <omp.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>

#include "spatial_order.h"

namespace tank_datum {
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr toPcl(const Points& points) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const auto& p : points) {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  }
  return cloud;
}

void findWithFlann(const Points& points, const NeighbourRows& rows, const BucketTree::RowsDone& done) {
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  const auto cloud = toPcl(points);
  tree.setInputCloud(cloud);
  const auto order = mortonOrder(points);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  const auto k = static_cast<std::size_t>(rows.k);
#pragma omp parallel num_threads(rows.threads > 0 ? rows.threads : omp_get_max_threads())
  {
    pcl::Indices found(k);
    std::vector<float> squared_distances(k);
#pragma omp for schedule(dynamic, 1024)
    for (std::ptrdiff_t query = 0; query < count; ++query) {
      const std::uint32_t& i = order[static_cast<std::size_t>(query)];
      tree.nearestKSearch((*cloud)[i], rows.k, found, squared_distances);
      std::copy(found.begin(), found.end(), rows.first + i * k);
      done(&i, 1);
    }
  }
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
