#pragma once

#include "tank_datum/core/export.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/search/normals.h"

namespace TANK_DATUM_API tank_datum {

/// Steps 1 and 2 of the method: the k nearest neighbours of every point, and the normal as the eigenvector of the
/// smallest eigenvalue of their covariance (ISPRS Archives 2018, normal vector of point cloud). The result does not
/// depend on the number of threads.
/// @param points   at least options.k of them [m], or none
/// @param threads  0 means all cores
/// @throws Error (Option) for fewer, for a refused option
Normals estimateNormals(const Points& points, const NormalOptions& options, int threads = 0);

/// Step 2 alone, for neighbours found elsewhere.
/// @param neighbours  points.size() rows of k
/// @throws Error (Option) for k < 1, for another number of rows
Normals fitNormals(const Points& points, Neighbours neighbours, int k, int threads = 0);

}  // namespace tank_datum
