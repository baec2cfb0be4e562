#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "tank_datum/fit/curves.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// A point at the shell: its height, and how far outside of the circle it is.
struct Hit {
  double z, off;
};

/// One azimuth sector: what stands at the shell and as near as a ringwall's face does, and the heights of what lies
/// beside it on either side, and farther in than a ringwall is wide.
struct Sector {
  std::vector<Hit> shell, around;
  std::vector<double> outside, inside, farther_in;
};

/// The sectors round a circle, three voxels wide.
/// @param points  thinned to one in a voxel [m]
/// @param band    half-width of what counts as standing at the shell [m]
std::vector<Sector> sectorsOf(const Points& points, double voxel, const Circle& circle, double band);

constexpr double kRingwallWidth = 0.6;      ///< the widest ringwall beyond the shell [m]
constexpr double kShortOfRingwall = 0.075;  ///< half of the way to the face of the narrowest ringwall [m]
constexpr double kFewestVoxels = 3.0;       ///< that a wall is high
constexpr double kHoleInVoxels = 3.0;       ///< between hits, two empty ones, that are still one wall

/// How far from the circle points of a wall are at most [m].
/// @param rms  of the wall about its circle [m]
inline double bandOf(double voxel, double rms) { return std::max(1.5 * voxel, 3.0 * rms); }

/// How far from its upright line they are at most [m].
inline double thicknessOf(double rms) { return std::max(kShortOfRingwall, 3.0 * rms); }

void sortByHeight(std::vector<Hit>& hits);

/// The longest stretch of heights without a hole.
/// @param hits  by height
/// @param hole  the least there is [m]
std::vector<Hit> longestRun(const std::vector<Hit>& hits, double hole);

/// Where a wall stands [m].
struct WallRun {
  double bottom, top;  ///< of its longest stretch without a hole
  double under;        ///< where it ends below if it goes on under holes, as under a girder that hides a part of it
};

/// The shell; none when it is no wall. What stands below it a hand's breadth off, the face of a ringwall, is none of
/// it.
/// @param thickness  how far its points are from their line at most [m]
std::optional<WallRun> shellRun(std::vector<Hit> hits, double voxel, double thickness);

/// Whether something beside the shell is about as high as its foot.
/// @param beside  heights [m]
bool hasFoundation(const std::vector<double>& beside, double foot, double voxel, double radius);

}  // namespace tank_datum
