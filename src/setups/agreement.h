#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "setups/repeated_points.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/setups/setups.h"

namespace tank_datum {

/// Finds how the setups of a ring disagree, from the arcs that two or more of them see, and moves each setup's points
/// by its correction. Those of a cloud merged without labels are told apart by the order of its points, where that says
/// them. A ring of one setup is left as it is.
/// @param repeated  points that were left out of the ring
/// @param scan      names the setups and their origins
/// @param threads   0 means all cores; the result does not depend on it
SetupAgreement agreeSetups(Ring& ring, const RepeatedPoints& repeated, const Scan& scan, const Tank& tank,
                           const SetupOptions& options, int threads = 0);

/// Reads where setups stood: rows name,x,y,z in the scan's frame, the name a file's stem or a label; a heading may come
/// first.
/// @return in metres
/// @throws Error (File) naming the line
std::map<std::string, Eigen::Vector3d> readSetupOrigins(const std::string& path, double metres_per_unit = 1.0);

}  // namespace tank_datum
