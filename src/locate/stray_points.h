#pragma once

#include "search/voxel_sample.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// Drops rows of which a scan knows nothing: those at zero of its own frame, which is how scanners write a beam without
/// a return, and those far beyond the rest.
/// @param zero  of the scan's own frame [m]
void dropNoReturns(Points& points, const Eigen::Vector3d& zero);

/// Whether a good part of the points float in the air, apart from surfaces: at two or four times the edge at which most
/// of the points share their voxels, many are alone still.
bool holdsStrays(const VoxelSample& sample);

/// The edge at which a good part of the points shares their voxels: where surfaces begin to close [m].
double closingEdge(const VoxelSample& sample);

/// The points that have company, as points of surfaces have: others within a few closing edges.
/// @param edge  closingEdge of a sample of the points [m]
Points withoutStrays(const Points& points, double edge);

/// Of each point 1 where withoutStrays leaves it out, else 0. Where that would be most of the points, none is.
std::vector<char> findStrays(const Points& points, double edge);

}  // namespace tank_datum
