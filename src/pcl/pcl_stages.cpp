#include "tank_datum/pcl/pcl_stages.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
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

}  // namespace

Neighbours findNeighbours(const NearestOf& search, std::size_t size, const pcl::Indices& chosen, int k, int threads) {
  const auto width = static_cast<std::size_t>(k);
  std::vector<std::int32_t> place(size, -1);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    place[static_cast<std::size_t>(chosen[i])] = static_cast<std::int32_t>(i);
  }
  Neighbours neighbours(chosen.size() * width);
  forEachIndex(chosen.size(), threads, [&](std::size_t i) {
    for (std::size_t ask = width;; ask = std::min(2 * ask, size)) {
      const pcl::Indices found = nearestInOrder(search, chosen[i], ask);
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

std::vector<Tank> locateTanksOf(const Scan& scan, const LocateOptions& options) {
  std::vector<Tank> tanks = locateTanks(scan, options);
  for (Tank& tank : tanks) tank = movedBy(scan.origin(), tank);
  return tanks;
}

RefinedStations refineStationsOf(const Scan& scan, const Tank& tank, const RefineOptions& options,
                                 const StationOptions& station_options, const CropOptions& crop) {
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
