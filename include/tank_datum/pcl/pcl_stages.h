#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>
#include <pcl/types.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/edge/centre_filter.h"
#include "tank_datum/foot/refine.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/crop.h"
#include "tank_datum/locate/locate.h"
#include "tank_datum/pcl/pcl_search.h"
#include "tank_datum/search/normals.h"
#include "tank_datum/stations/stations.h"

/// @file
/// The single stages on PCL clouds of any point type with x, y and z. Indices, circles, tanks and stations are the
/// cloud's own: its point numbers, its frame. growCandidates, between normals and centre filter, needs no cloud.

namespace TANK_DATUM_API tank_datum {

/// A cloud as a scan, without a copy; not finite points are dropped and counted.
/// @param indices  the points that belong to it; null for all
template <typename PointT>
Scan scanOf(std::shared_ptr<const pcl::PointCloud<PointT>> cloud,
            std::shared_ptr<const pcl::Indices> indices = nullptr) {
  const std::size_t rows = indices ? indices->size() : cloud->size();
  return Scan::fromRows(rows, [cloud, indices](std::uint64_t i) -> Eigen::Vector3d {
    const auto& p = (*cloud)[indices ? static_cast<std::size_t>((*indices)[i]) : i];
    return p.getVector3fMap().template cast<double>();
  });
}

/// A cloud's points in their order.
/// @throws Error (Option) naming the first point that is not finite: the stages number points as the cloud does
template <typename PointT>
Points pointsOf(const pcl::PointCloud<PointT>& cloud) {
  Points points;
  points.reserve(cloud.size());
  for (const PointT& p : cloud) {
    if (!p.getVector3fMap().allFinite()) {
      throw Error(Error::Kind::Option, "pcl", "point " + std::to_string(points.size()) + " of the cloud", "not finite",
                  "a cloud without such points (pcl::removeNaNFromPointCloud)");
    }
    points.push_back(p.getVector3fMap().template cast<double>());
  }
  return points;
}

/// A tank in a frame whose zero is elsewhere.
/// @param shift  added to its coordinates [m]
Tank movedBy(const Eigen::Vector3d& shift, const Tank& tank);

/// The tanks of a cloud in its own frame, best first; see locateTanks(const Scan&, ...).
template <typename PointT>
std::vector<Tank> locateTanks(const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud,
                              const LocateOptions& options) {
  const Scan scan = scanOf<PointT>(cloud);
  std::vector<Tank> tanks = locateTanks(scan, options);
  for (Tank& tank : tanks) tank = movedBy(scan.origin(), tank);
  return tanks;
}

/// Neighbours and normals of a cloud; see estimateNormals(const Points&, ...).
template <typename PointT>
Normals estimateNormals(const pcl::PointCloud<PointT>& cloud, const NormalOptions& options, int threads = 0) {
  return estimateNormals(pointsOf(cloud), options, threads);
}

/// The same with the neighbours that a search of PCL finds, which holds this cloud.
/// @throws Error (Option) when it finds fewer than asked for
template <typename PointT>
Normals estimateNormals(const pcl::PointCloud<PointT>& cloud, const pcl::search::Search<PointT>& search,
                        const NormalOptions& options, int threads = 0) {
  const Points points = pointsOf(cloud);
  pcl::Indices all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<pcl::index_t>(i);
  return fitNormals(points, findNeighbours(search, cloud, all, options.k, threads), options.k, threads);
}

/// Normals for PCL's own use.
inline pcl::PointCloud<pcl::Normal> toPcl(const Normals& normals) {
  pcl::PointCloud<pcl::Normal> cloud;
  for (const Eigen::Vector3f& n : normals.normals) cloud.push_back(pcl::Normal(n.x(), n.y(), n.z()));
  return cloud;
}

/// Candidates near the circle of the datum; see filterByCentre(const Points&, ...).
template <typename PointT>
EdgePoints filterByCentre(const pcl::PointCloud<PointT>& cloud, const std::vector<std::int32_t>& candidates,
                          const std::optional<Circle>& start, const CentreFilterOptions& options) {
  return filterByCentre(pointsOf(cloud), candidates, start, options);
}

/// Crops the ring of a tank out of a cloud and refines the stations on it; see refineStations(..., const Ring&, ...).
/// @param tank  in the cloud's frame
template <typename PointT>
Refined refineStations(std::vector<Station>& stations, const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud,
                       const Tank& tank, const RefineOptions& options, const StationOptions& station_options,
                       const CropOptions& crop = {}) {
  const Scan scan = scanOf<PointT>(cloud);
  const Tank local = movedBy(-scan.origin(), tank);
  Refined refined = refineStations(stations, cropRing(scan, local, crop), local, options, station_options);
  for (Station& station : stations) {
    station.x += scan.origin().x();
    station.y += scan.origin().y();
    station.z += scan.origin().z();
  }
  refined.circle.center += scan.origin().head<2>();
  return refined;
}

}  // namespace tank_datum
