#pragma once

#include <string>
#include <vector>

#include "locate/wall_map.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// A circle on which walls stand.
struct WallCircle {
  Circle circle;
  double rms = 0;             ///< of its walls about it [m]
  double coverage = 0;        ///< arc on which walls face the centre [rad]
  std::string rejected = {};  ///< why it is no shell; empty when it may be one
};

/// Circles of at least options.min_radius with walls on at least options.min_arc, one after the other by seen arc; the
/// walls of a circle are taken away before the next is looked for. Those that are rejected are among them, and at the
/// end the best of those that are seen along too short an arc.
std::vector<WallCircle> findWallCircles(const std::vector<WallCell>& walls, double voxel, const LocateOptions& options);

}  // namespace tank_datum
