#pragma once

#include "tank_datum/io/scan.h"
#include "tank_datum/search/normals.h"

namespace tank_datum {

/// Steps 1 and 2 of the method as PCL does them: neighbours by pcl::KdTreeFLANN, each normal by pcl::NormalEstimation
/// from the neighbours just found, so that nothing is searched twice. Coordinates and sums are float32.
/// @param points  at least k of them, near their origin [m]
Normals estimateNormalsWithPcl(const Points& points, int k, int threads);

}  // namespace tank_datum
