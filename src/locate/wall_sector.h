#pragma once

#include <vector>

#include "tank_datum/fit/curves.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// A point at the shell: its height, and how far outside of the circle it is.
struct Hit {
  double z, off;
};

/// One azimuth sector: what stands at the shell, and the heights of what lies beside it on either side.
struct Sector {
  std::vector<Hit> shell;
  std::vector<double> outside, inside;
};

/// The sectors round a circle, three voxels wide.
/// @param points  thinned to one in a voxel [m]
/// @param band    half-width of what counts as standing at the shell [m]
std::vector<Sector> sectorsOf(const Points& points, double voxel, const Circle& circle, double band);

/// Bottom and top of the shell; false when it is no wall. What stands below it a hand's breadth off, the face of a
/// ringwall, is none of it.
/// @param thickness  how far its points are from their line at most [m]
bool shellRun(const std::vector<Hit>& hits, double voxel, double thickness, double& bottom, double& top);

/// The height from which on a wall stands behind what is seen of it below, as a shell does upon a ringwall: the face
/// of one stands out by more than `least`, all the way down, and is two metres high at the most. NaN where there is
/// none [m].
/// @param least  how far a ringwall's face is from the shell at least [m]
double stepBackHeight(const std::vector<Hit>& hits, double voxel, double least);

/// Whether something beside the shell is about as high as its foot.
/// @param beside  heights [m]
bool hasFoundation(const std::vector<double>& beside, double foot, double voxel, double radius);

}  // namespace tank_datum
