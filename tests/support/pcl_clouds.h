#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

#include "support/made_clouds.h"
#include "tank_datum/datum.h"

/// The made clouds as PCL's.
namespace tank_datum::pcl_clouds {

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr cloudOf(const Points& points) {
  auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  for (const Eigen::Vector3d& p : points) {
    PointT point;
    point.getVector3fMap() = p.cast<float>();
    cloud->push_back(point);
  }
  return cloud;
}

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr tankCloud(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  return cloudOf<PointT>(made_clouds::tankPoints(shift));
}

/// Goes straight to the edge points of the made tank.
inline DatumOptions toTheEdge(const Eigen::Vector2d& center = {0, 0}) {
  DatumOptions options;
  options.method = Method::Paper;
  options.tank = Circle{center, made_clouds::kRadius};
  return options;
}

}  // namespace tank_datum::pcl_clouds
