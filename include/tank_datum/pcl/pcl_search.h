#pragma once

#include <pcl/point_cloud.h>
#include <pcl/search/search.h>
#include <pcl/types.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/parallel.h"
#include "tank_datum/search/normals.h"

namespace TANK_DATUM_API tank_datum {

/// Neighbours of a cloud's point as a search of PCL gives them, put in order of distance: not every search does.
template <typename PointT>
pcl::Indices nearestOf(const pcl::search::Search<PointT>& search, const pcl::PointCloud<PointT>& cloud,
                       pcl::index_t point, int k) {
  pcl::Indices found;
  std::vector<float> squared_distances;
  const int met = search.nearestKSearch(cloud, point, k, found, squared_distances);
  std::vector<std::size_t> order(static_cast<std::size_t>(met));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return squared_distances[a] < squared_distances[b]; });
  pcl::Indices sorted;
  for (const std::size_t i : order) sorted.push_back(found[i]);
  return sorted;
}

/// Step 1 of the method through a search of PCL: the k nearest of every chosen point among the chosen points. A search
/// that holds more of the cloud is asked for more neighbours until k chosen ones are among them.
/// @param search  over the cloud or at least its chosen points; asked from several threads at once
/// @param chosen  finite points of the cloud, each at most once
/// @return chosen.size() rows of k places in `chosen`, nearest first
/// @throws Error (Option) when the search finds fewer than k of them
template <typename PointT>
Neighbours findNeighbours(const pcl::search::Search<PointT>& search, const pcl::PointCloud<PointT>& cloud,
                          const pcl::Indices& chosen, int k, int threads = 0) {
  const auto width = static_cast<std::size_t>(k);
  std::vector<std::int32_t> place(cloud.size(), -1);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    place[static_cast<std::size_t>(chosen[i])] = static_cast<std::int32_t>(i);
  }
  Neighbours neighbours(chosen.size() * width);
  forEachIndex(chosen.size(), threads, [&](std::size_t i) {
    for (std::size_t ask = width;; ask = std::min(2 * ask, cloud.size())) {
      const pcl::Indices found = nearestOf(search, cloud, chosen[i], static_cast<int>(ask));
      std::size_t kept = 0;
      for (std::size_t j = 0; j < found.size() && kept < width; ++j) {
        const std::int32_t at = place[static_cast<std::size_t>(found[j])];
        if (at >= 0) neighbours[i * width + kept++] = at;
      }
      if (kept == width) return;
      if (found.size() < ask || ask >= cloud.size()) {
        throw Error(Error::Kind::Option, "normals", "neighbours found by the search method", std::to_string(kept),
                    std::to_string(k));
      }
    }
  });
  return neighbours;
}

}  // namespace tank_datum
