#include "tank_datum/pcl/pcl_stages.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/refusal.h"
#include "foot/refine.h"
#include "locate/crop.h"
#include "locate/locate.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

/// A tank in a frame whose zero is elsewhere.
/// @param shift  added to its coordinates [m]
Tank movedBy(const Eigen::Vector3d& shift, const Tank& tank) {
  Tank moved = tank;
  moved.circle.center += shift.head<2>();
  if (moved.foot.valid()) moved.foot.coefficients[0] += shift.z();
  return moved;
}

/// Neighbours as a search gives them, put in order of distance.
pcl::Indices nearestInOrder(const NearestOf& search, pcl::index_t point, std::size_t k) {
  pcl::Indices found;
  std::vector<float> squared_distances;
  const int met = search(point, static_cast<int>(k), found, squared_distances);
  std::vector<std::size_t> order(static_cast<std::size_t>(met));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return squared_distances[a] < squared_distances[b]; });
  pcl::Indices sorted;
  for (const std::size_t i : order) sorted.push_back(found[i]);
  return sorted;
}

/// The share of the variance of some points that lies along a direction.
float curvatureAlong(const Eigen::Vector3d& normal, const Points& points, const std::int32_t* chosen, std::size_t k) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < k; ++j) mean += points[static_cast<std::size_t>(chosen[j])] / static_cast<double>(k);
  double along = 0.0, all = 0.0;
  for (std::size_t j = 0; j < k; ++j) {
    const Eigen::Vector3d arm = points[static_cast<std::size_t>(chosen[j])] - mean;
    along += square(arm.dot(normal));
    all += arm.squaredNorm();
  }
  return all > 0.0 ? static_cast<float>(along / all) : 0.0F;
}

/// Refuses what no search over the cloud answers: points that it does not have, or one and the same again.
void requireUsable(const pcl::Indices& found, pcl::index_t point, std::size_t size) {
  const auto refuse = [&](const std::string& what) {
    throw Error(Error::Kind::Option, "normals",
                "neighbours of point " + std::to_string(point) + " by the search method", what,
                "points of the cloud, each once: is the search over another cloud?");
  };
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (found[j] < 0 || static_cast<std::size_t>(found[j]) >= size) {
      refuse("point " + std::to_string(found[j]) + " of " + std::to_string(size));
    }
    if (j > 0 && found[j] == found[j - 1]) refuse("point " + std::to_string(found[j]) + " twice");
  }
}

}  // namespace

void requireWithin(const char* stage, const char* name, const std::vector<std::int32_t>& indices, std::size_t points) {
  for (const std::int32_t i : indices) {
    if (i >= 0 && static_cast<std::size_t>(i) < points) continue;
    throw Error(Error::Kind::Option, stage, name, std::to_string(i),
                "one of the cloud's " + std::to_string(points) + " points");
  }
}

void requireValid(const NormalOptions& options) { refuseFirst(firstError(options)); }

Neighbours findNeighbours(const NearestOf& search, std::size_t size, const pcl::Indices& chosen, int k, int threads) {
  if (k < 1) throw Error(Error::Kind::Option, "normals", "k", std::to_string(k), ">= 1");
  const auto width = static_cast<std::size_t>(k);
  std::vector<std::int32_t> place(size, -1);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    place[static_cast<std::size_t>(chosen[i])] = static_cast<std::int32_t>(i);
  }
  Neighbours neighbours(chosen.size() * width);
  forEachIndex(chosen.size(), threads, [&](std::size_t i) {
    for (std::size_t ask = width;; ask = std::min(2 * ask, size)) {
      const pcl::Indices found = nearestInOrder(search, chosen[i], ask);
      requireUsable(found, chosen[i], size);
      std::size_t kept = 0;
      for (std::size_t j = 0; j < found.size() && kept < width; ++j) {
        const std::int32_t at = place[static_cast<std::size_t>(found[j])];
        if (at >= 0) neighbours[i * width + kept++] = at;
      }
      if (kept == width) return;
      if (found.size() < ask || ask >= size) {
        throw Error(Error::Kind::Option, "normals", "neighbours found by the search method", std::to_string(kept),
                    std::to_string(k));
      }
    }
  });
  return neighbours;
}

pcl::PointCloud<pcl::Normal> toPcl(const Normals& normals, const Points& points) {
  const auto k = static_cast<std::size_t>(std::max(normals.k, 0));
  if (points.size() != normals.size() || normals.neighbours.size() != points.size() * k) {
    throw Error(Error::Kind::Option, "normals", "points", std::to_string(points.size()),
                "as many as normals, " + std::to_string(normals.size()) + ", with their neighbours");
  }
  pcl::PointCloud<pcl::Normal> cloud = toPcl(normals);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].curvature = curvatureAlong(normals.normals[i].cast<double>(), points, &normals.neighbours[i * k], k);
  }
  return cloud;
}

std::vector<Tank> locateTanksOf(const Scan& scan, const LocateOptions& options) {
  refuseFirst(firstError(options));
  std::vector<Tank> tanks = locateTanks(scan, options);
  for (Tank& tank : tanks) tank = movedBy(scan.origin(), tank);
  return tanks;
}

RefinedStations refineStationsOf(const Scan& scan, const Tank& tank, const RefineOptions& options,
                                 const StationOptions& station_options, const CropOptions& crop) {
  refuseFirst(firstError(options));
  refuseFirst(firstError(station_options));
  refuseFirst(firstError(crop));
  if (!tank.circle.valid() || !tank.foot.valid())
    throw Error(Error::Kind::Option, "refine", "tank", "without circle or foot", "one that locateTanks gave");
  const Tank local = movedBy(-scan.origin(), tank);
  RefinedStations result;
  RefinedFoot foot = refineStations(cropRing(scan, local, crop), local, options, station_options);
  result.stations = withParts(emptyStations(station_options), foot.stations);
  result.refined = std::move(foot.refined);
  for (Station& station : result.stations) {
    station.x += scan.origin().x();
    station.y += scan.origin().y();
    station.z += scan.origin().z();
  }
  result.refined.circle.center += scan.origin().head<2>();
  return result;
}

}  // namespace tank_datum
