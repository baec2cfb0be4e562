#include "search/pcl_normals.h"

#include <pcl/features/normal_3d.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <new>
#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/kdtree/impl/kdtree_flann.hpp>

#include "core/parallel.h"
#include "search/spatial_order.h"

namespace tank_datum {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// By FLANN's distance of three coordinates, the same to the last bit as that of any number, of which PCL's library
/// holds the tree: compiled with OpenMP, where FLANN opens a region for every query. This one is compiled here.
using Tree = pcl::KdTreeFLANN<pcl::PointXYZ, flann::L2_3D<float>>;

Cloud::Ptr roundedCloud(const Points& points) {
  const auto cloud = std::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const auto& p : points) {
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  }
  return cloud;
}

/// FLANN goes on with a null pointer where there is no memory for its nodes: asks first whether there is.
/// @throws std::bad_alloc
void requireMemoryForNodes(std::size_t points) {
  constexpr std::size_t kOfPoint = 64, kOfOtherThreads = std::size_t{16} << 20;  // bytes
  ::operator delete(::operator new(points* kOfPoint + kOfOtherThreads));
}

}  // namespace

Normals estimateNormalsWithPcl(const Points& points, int k, int threads) {
  const auto width = static_cast<std::size_t>(k);
  Normals result;
  result.k = k;
  result.neighbours.resize(points.size() * width);
  result.normals.resize(points.size());
  Tree tree;
  Cloud::Ptr cloud;
  std::vector<std::uint32_t> order;  // neighbouring queries go through the same nodes
  forEachIndex(2, threads, [&](std::size_t task) {
    if (task == 1) {
      order = mortonOrder(points);
    } else {
      cloud = roundedCloud(points);
      requireMemoryForNodes(points.size());
      tree.setInputCloud(cloud);
    }
  });
  forEachRun(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    pcl::Indices found(width);
    std::vector<float> squared_distances(width);
    float curvature = 0;
    for (std::size_t query = begin; query < end; ++query) {
      const std::uint32_t i = order[query];
      tree.nearestKSearch((*cloud)[i], static_cast<pcl::uindex_t>(k), found, squared_distances);
      std::copy(found.begin(), found.end(), result.neighbours.begin() + static_cast<std::ptrdiff_t>(i * width));
      Eigen::Vector3f& n = result.normals[i];
      // Its eigenvalues take sines of float32 from 0 to pi / 3, of which glibc 2.36 gives all alike on every processor.
      estimation.computePointNormal(*cloud, found, n.x(), n.y(), n.z(), curvature);
    }
  });
  return result;
}

}  // namespace tank_datum
