#include "tank_datum/normals.h"

#include <omp.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>

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

Eigen::Vector3f normalOf(const Points& points, std::size_t i, const std::int32_t* neighbours, int k) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (int j = 0; j < k; ++j) {
    const Eigen::Vector3d d = points[static_cast<std::size_t>(neighbours[j])] - points[i];
    sum += d;
    squares += d * d.transpose();
  }
  const Eigen::Matrix3d covariance = squares - sum * sum.transpose() / k;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  return solver.eigenvectors().col(0).cast<float>();
}

}  // namespace

const char* nameOf(SearchEngine engine) {
  switch (engine) {
    case SearchEngine::Flann:
      return "flann";
  }
  return "";
}

std::string firstError(const NormalOptions& options) {
  if (options.k < 3) return "normals.k = " + std::to_string(options.k) + " (must be >= 3)";
  return {};
}

Normals estimateNormals(const Points& points, const NormalOptions& options, int threads) {
  const auto k = static_cast<std::size_t>(options.k);
  Normals result;
  result.k = options.k;
  result.neighbours.resize(points.size() * k);
  result.normals.resize(points.size());
  if (points.empty()) return result;

  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  const auto cloud = toPcl(points);
  tree.setInputCloud(cloud);
  const auto order = mortonOrder(points);
  const auto count = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_max_threads())
  {
    pcl::Indices found(k);
    std::vector<float> squared_distances(k);
#pragma omp for schedule(dynamic, 1024)
    for (std::ptrdiff_t query = 0; query < count; ++query) {
      const std::size_t i = order[static_cast<std::size_t>(query)];
      tree.nearestKSearch((*cloud)[i], options.k, found, squared_distances);
      std::copy(found.begin(), found.end(), result.neighbours.begin() + static_cast<std::ptrdiff_t>(i * k));
      result.normals[i] = normalOf(points, i, &result.neighbours[i * k], options.k);
    }
  }
  return result;
}

Normals fitNormals(const Points& points, std::vector<std::int32_t> neighbours, int k, int threads) {
  Normals result;
  result.k = k;
  result.neighbours = std::move(neighbours);
  result.normals.resize(points.size());
  const auto count = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for schedule(static) num_threads(threads > 0 ? threads : omp_get_max_threads())
  for (std::ptrdiff_t row = 0; row < count; ++row) {
    const auto i = static_cast<std::size_t>(row);
    result.normals[i] = normalOf(points, i, &result.neighbours[i * static_cast<std::size_t>(k)], k);
  }
  return result;
}

}  // namespace tank_datum
