#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/default_init_allocator.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/io/scan.h"

namespace TANK_DATUM_API tank_datum {

enum class SearchEngine {
  Flann,    ///< pcl::KdTreeFLANN and pcl::NormalEstimation
  Buckets,  ///< BucketTree: the same neighbours, found for a bucket of points at a time; normals with sums in double
};

/// The name used at the command line and in files: "flann", "buckets".
const char* nameOf(SearchEngine engine);

struct NormalOptions {
  int k = 20;                                 ///< neighbours of a point, the point itself included
  SearchEngine search = SearchEngine::Flann;  ///< who finds them and fits the normals; both find the same neighbours
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const NormalOptions& options);

/// Rows of k point indices, nearest first, the point itself included.
using Neighbours = std::vector<std::int32_t, DefaultInitAllocator<std::int32_t>>;

/// Neighbours and normals of a cloud. The lists are kept so that region growing need not search again.
struct Normals {
  int k = 0;
  Neighbours neighbours;                 ///< size() rows of k
  std::vector<Eigen::Vector3f> normals;  ///< unit length, sign undefined

  std::size_t size() const { return normals.size(); }
};

/// Steps 1 and 2 of the method: the k nearest neighbours of every point, and the normal as the eigenvector of the
/// smallest eigenvalue of their covariance (ISPRS Archives 2018, normal vector of point cloud). The result does not
/// depend on the number of threads.
/// @param points   at least options.k of them [m], or none
/// @param threads  0 means all cores
/// @throws Error (Option) for fewer
Normals estimateNormals(const Points& points, const NormalOptions& options, int threads = 0);

/// Step 2 alone, for neighbours found elsewhere.
/// @param neighbours  points.size() rows of k
/// @param threads     0 means all cores
Normals fitNormals(const Points& points, Neighbours neighbours, int k, int threads = 0);

}  // namespace tank_datum
