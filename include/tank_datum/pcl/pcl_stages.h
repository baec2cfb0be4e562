#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/search/estimate_normals.h"
#include "tank_datum/stations/stations.h"

/// @file
/// The single stages on PCL clouds of any point type with x, y and z. Indices, circles, tanks and stations are the
/// cloud's own: its point numbers, its frame. growCandidates, between normals and centre filter, needs no cloud.

namespace TANK_DATUM_API tank_datum {

/// @throws Error (Option) naming the first index that a cloud of so many points does not have
void requireWithin(const char* stage, const char* name, const std::vector<std::int32_t>& indices, std::size_t points);

/// A cloud as a scan, without a copy; not finite points are dropped and counted.
/// @param indices  the points that belong to it; null for all
/// @throws Error (Option) without a cloud, or for an index that it does not have
template <typename PointT>
Scan scanOf(std::shared_ptr<const pcl::PointCloud<PointT>> cloud,
            std::shared_ptr<const pcl::Indices> indices = nullptr) {
  if (!cloud) throw Error(Error::Kind::Option, "pcl", "cloud", "none", "a cloud");
  if (indices) requireWithin("pcl", "index", *indices, cloud->size());
  const std::size_t rows = indices ? indices->size() : cloud->size();
  const auto row = [cloud, indices](std::uint64_t i) -> Eigen::Vector3d {
    const auto& p = (*cloud)[indices ? static_cast<std::size_t>((*indices)[i]) : i];
    return p.getVector3fMap().template cast<double>();
  };
  return Scan::fromRows(rows, row, {true});
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

/// Which of a scan's points these are, for a caller who holds the scan in memory and wants his own rows back.
/// @param points  taken from the scan's blocks, bit for bit; of points with equal coordinates each gets a row of its
/// own
/// @return per point its place among the scan's finite points, counted from 0
/// @throws std::logic_error for a point that is not the scan's
std::vector<std::size_t> rowsOf(const Points& points, const Scan& scan);

/// The k points of a cloud that a search finds nearest to one of them, and their squared distances; returns how many.
using NearestOf = std::function<int(pcl::index_t point, int k, pcl::Indices& found, std::vector<float>& squared)>;

/// Step 1 of the method through a search: the k nearest of every chosen point among the chosen points, in order of
/// distance, which not every search of PCL keeps to. A search that holds more of the cloud is asked for more neighbours
/// until k chosen ones are among them.
/// @param search  over the cloud or at least its chosen points; asked from several threads at once
/// @param size    of the cloud
/// @param chosen  finite points of the cloud, each at most once
/// @return chosen.size() rows of k places in `chosen`, nearest first
/// @throws Error (Option) when the search finds fewer than k of them
Neighbours findNeighbours(const NearestOf& search, std::size_t size, const pcl::Indices& chosen, int k,
                          int threads = 0);

/// The same through a search of PCL.
template <typename PointT>
Neighbours findNeighbours(const pcl::search::Search<PointT>& search, const pcl::PointCloud<PointT>& cloud,
                          const pcl::Indices& chosen, int k, int threads = 0) {
  const auto nearest = [&](pcl::index_t point, int count, pcl::Indices& found, std::vector<float>& squared) {
    return search.nearestKSearch(cloud, point, count, found, squared);
  };
  return findNeighbours(nearest, cloud.size(), chosen, k, threads);
}

/// The tanks of a scan in its own frame, best first.
std::vector<Tank> locateTanksOf(const Scan& scan, const LocateOptions& options);

/// The tanks of a cloud in its own frame, best first.
template <typename PointT>
std::vector<Tank> locateTanks(const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud,
                              const LocateOptions& options) {
  return locateTanksOf(scanOf<PointT>(cloud), options);
}

/// Neighbours and normals of a cloud; see estimateNormals(const Points&, ...).
template <typename PointT>
Normals estimateNormals(const pcl::PointCloud<PointT>& cloud, const NormalOptions& options, int threads = 0) {
  return estimateNormals(pointsOf(cloud), options, threads);
}

/// @throws Error (Option) naming the first refused option
void requireValid(const NormalOptions& options);

/// The same with the neighbours that a search of PCL finds, which holds this cloud.
/// @throws Error (Option) a refused option; when the search finds fewer than asked for
template <typename PointT>
Normals estimateNormals(const pcl::PointCloud<PointT>& cloud, const pcl::search::Search<PointT>& search,
                        const NormalOptions& options, int threads = 0) {
  requireValid(options);
  const Points points = pointsOf(cloud);
  pcl::Indices all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<pcl::index_t>(i);
  return fitNormals(points, findNeighbours(search, cloud, all, options.k, threads), options.k, threads);
}

/// Normals for PCL's own use; their curvature is not known (NaN) without the cloud.
inline pcl::PointCloud<pcl::Normal> toPcl(const Normals& normals) {
  pcl::PointCloud<pcl::Normal> cloud;
  cloud.reserve(normals.size());
  for (const Eigen::Vector3f& n : normals.normals) {
    cloud.push_back(pcl::Normal(n.x(), n.y(), n.z(), std::numeric_limits<float>::quiet_NaN()));
  }
  return cloud;
}

/// The same with their curvature as pcl::NormalEstimation has it: the smallest eigenvalue of the neighbours' covariance
/// over the sum of all three, 0 for a plane and 1/3 at most.
/// @param points  those the normals are of
/// @throws Error (Option) for others
pcl::PointCloud<pcl::Normal> toPcl(const Normals& normals, const Points& points);

/// The same of a cloud.
template <typename PointT>
pcl::PointCloud<pcl::Normal> toPcl(const Normals& normals, const pcl::PointCloud<PointT>& cloud) {
  return toPcl(normals, pointsOf(cloud));
}

/// Candidates near the circle of the datum; see filterByCentre(const Points&, ...).
/// @throws Error (Option) a refused option; a candidate that the cloud does not have
template <typename PointT>
EdgePoints filterByCentre(const pcl::PointCloud<PointT>& cloud, const std::vector<std::int32_t>& candidates,
                          const std::optional<Circle>& start, const CentreFilterOptions& options) {
  requireWithin("pcl", "candidate", candidates, cloud.size());
  return filterByCentre(pointsOf(cloud), candidates, start, options);
}

/// The stations of a datum, with what was refined for the tank as a whole.
struct RefinedStations {
  std::vector<Station> stations;
  Refined refined;
};

/// Crops the ring of a tank out of a scan and fits the stations on it.
/// @param tank  in the scan's own frame, as the result is
/// @throws Error (Option) a refused option; a tank without a circle or a foot
RefinedStations refineStationsOf(const Scan& scan, const Tank& tank, const RefineOptions& options,
                                 const StationOptions& station_options, const CropOptions& crop = {});

/// The same of a cloud.
template <typename PointT>
RefinedStations refineStations(const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud, const Tank& tank,
                               const RefineOptions& options, const StationOptions& station_options,
                               const CropOptions& crop = {}) {
  return refineStationsOf(scanOf<PointT>(cloud), tank, options, station_options, crop);
}

}  // namespace tank_datum
