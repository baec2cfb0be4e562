#pragma once

#include <cstdint>
#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The scan thinned to one point in a voxel.
struct Sample {
  Points points;
  double voxel = 0;     ///< edge [m]
  bool strays = false;  ///< there were many, and are no more
};

/// A tank needs no more than every n-th of so many points to be found; n is odd, since rows of a scan often have even
/// lengths.
std::uint64_t strideOf(std::uint64_t points);

/// About every n-th point of the scan, without those that no surface returned.
Points lookAt(const Scan& scan, int threads);

/// The edge of voxels as small as can be numbered on the way to the farthest point [m]; every smallest radius has the
/// same ladder of voxels, and so the same tanks.
double finestVoxel(const Points& points, int threads);

/// The scan thinned to a ladder of voxels, from where the densest surfaces just close (a tenth of the voxels hold two
/// points) to an eighth of the smallest diameter or, where a tank may be larger than it need be, to a small part of the
/// scan, and at least three rungs. Which rung shows a tank best depends on how much denser it was scanned than what
/// stands around it.
std::vector<Sample> samplesOf(const Points& looked_at, const LocateOptions& options, int threads);

/// The same with all points, where strays were left out: beside ground that was scanned from a step away, walls at the
/// end of a scanner's reach look like them.
std::vector<Sample> samplesOfAll(const Points& looked_at, const LocateOptions& options, int threads);

}  // namespace tank_datum
