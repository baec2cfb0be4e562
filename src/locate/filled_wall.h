#pragma once

#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Of a wall that is lower than tanks are, the share of what is seen of it behind which soil fills it, farther in than
/// a ringwall is wide; a shell upon a ringwall hides what is there. 0 of a higher one, behind whose top a roof lies.
/// @param points  thinned to one in a voxel [m]
double shareFilled(const Points& points, double voxel, const Tank& tank);

}  // namespace tank_datum
