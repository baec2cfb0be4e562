#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/search/normals.h"

namespace TANK_DATUM_API tank_datum {

struct GrowingOptions {
  double angle = 0.7853981633974483;  ///< theta: normals further apart than this mark a crease [rad], 45 degrees
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const GrowingOptions& options);

/// Step 3 of the method: every point is a seed once; a neighbour whose normal makes an angle acos|n1.n2| above theta
/// with the seed's is a candidate. In the paper a point taken is no seed any more, so its result depends on the order
/// of the points; here every point is a seed, which no shuffle or second thread can change.
/// @param normals  with their neighbour lists
/// @return indices of the candidates, ascending
std::vector<std::int32_t> growCandidates(const Normals& normals, const GrowingOptions& options, int threads = 0);

}  // namespace tank_datum
