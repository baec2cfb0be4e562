#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/edge/edge_points.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/search/normals.h"

namespace TANK_DATUM_API tank_datum {

/// Step 3 of the method: every point is a seed once; a neighbour whose normal makes an angle acos|n1.n2| above theta
/// with the seed's is a candidate. In the paper a point taken is no seed any more, so its result depends on the order
/// of the points; here every point is a seed, which no shuffle or second thread can change.
/// @param normals  with their neighbour lists
/// @return indices of the candidates, ascending; throws Error (Option) for a refused option, as filterByCentre does
std::vector<std::int32_t> growCandidates(const Normals& normals, const GrowingOptions& options, int threads = 0);

/// Step 4 of the method: candidates whose distance from the centre is not within a threshold of the radius are noise.
/// @param start  the tank's circle when known; without one it is searched among the candidates
/// @return no indices and an invalid circle when the candidates determine none
EdgePoints filterByCentre(const Points& points, const std::vector<std::int32_t>& candidates,
                          const std::optional<Circle>& start, const CentreFilterOptions& options);

}  // namespace tank_datum
