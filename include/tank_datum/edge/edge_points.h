#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/fit/curves.h"

namespace TANK_DATUM_API tank_datum {

struct GrowingOptions {
  double angle = 0.7853981633974483;  ///< theta: normals further apart than this mark a crease [rad], 45 degrees
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const GrowingOptions& options);

struct CentreFilterOptions {
  /// The paper's distance threshold: how far from the circle an edge point may lie [m]; 0 takes 0.1 m (out-of-roundness
  /// of a shell foot within API 653's tolerances) or a tenth of the radius, whichever is less.
  double tolerance = 0.0;
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const CentreFilterOptions& options);

/// Candidates near the circle of the datum, in order round it.
struct EdgePoints {
  Circle circle;                      ///< fitted robustly to the candidates [m]
  double tolerance = 0;               ///< threshold used [m]
  std::vector<std::int32_t> indices;  ///< of the cloud's points, by ascending azimuth about the circle's centre
  std::vector<double> azimuths;       ///< the same points' azimuths in [0, 2 pi) [rad]
};

}  // namespace tank_datum
