#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// A circle on which walls stand, and why it is none of a tank's.
struct RejectedCircle {
  Circle circle;          ///< relative to the scan's origin [m]
  double coverage = 0.0;  ///< arc on which walls face the centre [rad]
  std::string reason;     ///< "its walls are flat, like a box's"
};

/// The tanks of a scan, best first: the one whose shell is seen along the longest arc [m].
///
/// Columns of the thinned sample that are filled over some height are walls; circles are drawn through three of them
/// and kept by the arc on which walls face the centre (RANSAC). A circle whose walls do not turn with the azimuth is a
/// box; one that encloses a taller one is a bund wall; one just outside of another and below its foot is a ringwall.
/// @param threads   0 means all cores; the tanks do not depend on it
/// @param rejected  where to put the circles that are no tanks, the longest seen arc first; may be null
std::vector<Tank> locateTanks(const Scan& scan, const LocateOptions& options, int threads = 0,
                              std::vector<RejectedCircle>* rejected = nullptr);

/// A tank whose circle is known (--tank X,Y,R); only side, foot and coverage are looked for.
std::optional<Tank> describeTank(const Scan& scan, const Circle& circle, const LocateOptions& options, int threads = 0);

}  // namespace tank_datum
