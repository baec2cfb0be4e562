#pragma once

#include <string>

#include "tank_datum/export.h"
#include "tank_datum/locate.h"
#include "tank_datum/scan.h"

namespace TANK_DATUM_API tank_datum {

struct CropOptions {
  double reach = 0.5;  ///< half-width of the ring in radius and height [m]; at most half of the radius
  std::size_t search_points = 1'000'000;  ///< the ring is thinned to at most this many for the search of edge points
};

/// One line naming the first refused field, or empty.
std::string firstError(const CropOptions& options);

/// The points of a scan near the datum, about the tank's centre.
struct Ring {
  Points points;      ///< every scan point in the ring, relative to the scan's origin [m]
  Points search;      ///< the same thinned by voxels to an even spacing, for the search of edge points
  double reach = 0;   ///< half-width used [m]
  ScanCounts counts;  ///< what the pass over the scan met
};

/// Keeps the points whose distance from the shell and from the coarse foot is at most the reach (enlarged by the
/// accuracy of the coarse figures).
/// @param also  shown every block of the scan, for those who need another part of it: a scan is long to read
Ring cropRing(const Scan& scan, const Tank& tank, const CropOptions& options, const Scan::Visitor& also = {});

}  // namespace tank_datum
