#pragma once

#include <cmath>
#include <vector>

#include "locate/wall_sector.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

constexpr double kHighestRingwall = 2.0;  ///< above the ground [m]

/// Where a wall stands behind what is seen of it below, as a shell does upon a ringwall; NaN where it nowhere does.
struct StepBack {
  double height = kUnknown;   ///< from which on it does [m]
  double off = kUnknown;      ///< of the upper wall there, outside of the circle [m]
  double width = kUnknown;    ///< how far the lower one stands out of it [m]
  double bottom = kUnknown;   ///< of the lower one [m]
  double top = kUnknown;      ///< of the upper one [m]
  double scatter = kUnknown;  ///< of both about their lines, mean of the absolute values [m]

  bool found() const { return std::isfinite(height); }
  double faceHeight() const { return height - bottom; }  ///< of the lower one [m]
};

/// The middle of what the steps that were found say; NaN without any.
double medianOf(const std::vector<StepBack>& steps, double (*value)(const StepBack&));

/// The face of a ringwall stands out by more than `least`, all the way down, and is two metres high at the most.
/// @param hits   of all that stands or lies around [m]
/// @param least  how far a ringwall's face is from the shell at least [m]
StepBack findStepBack(std::vector<Hit> hits, double voxel, double least);

}  // namespace tank_datum
