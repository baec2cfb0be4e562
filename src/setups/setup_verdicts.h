#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/repeated_points.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/setups/setups.h"

namespace tank_datum {

/// What is said of a setup whose points were counted and whose correction is known. It was adjusted when a part of its
/// correction is more than three of its standard errors.
/// @param overlaps  whether another setup sees what it sees
SetupVerdict verdictOf(const Setup& setup, bool bad, bool overlaps);

/// Names those as duplicates of which nine in ten points were there already.
void markDuplicates(std::vector<Setup>& setups, const RepeatedPoints& repeated);

/// Leaves out the bad setups' points in arcs where other setups have as many as tell a foot, a hundred.
void dropBad(Ring& ring, const std::vector<Setup>& setups, const Eigen::Vector2d& center);

}  // namespace tank_datum
