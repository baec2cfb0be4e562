#pragma once

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// The step that x and y were rounded to before the points were turned about z, as to plant north: points of a wall
/// still share both with others, and neighbouring places lie a step apart along or across one direction. (Walls drawn
/// in columns do so in all directions.) 0: none is seen [m].
/// @param finest  steps are no smaller
double turnedGridStep(const Points& points, double finest);

}  // namespace tank_datum
