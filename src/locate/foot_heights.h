#pragma once

#include <vector>

#include "core/units.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {

constexpr double kFoundationArc = 30.0 * kDegree;  ///< in one piece: a foot that is hidden elsewhere is one [rad]

/// How far from a fit of feet they may lie [m].
struct FootWindow {
  double from_fit;   ///< those that it is of
  double below_fit;  ///< an arc in which feet agree: what is looked at about the fit reaches no deeper
};

/// The foot against azimuth. Shells that end above a shadow outnumber, at times, those seen to their foot, but nothing
/// of a shell lies below it: the fit starts from the lowest fifth, takes what agrees with it, and is lowered as a whole
/// to what holds the lowest arc in which feet agree.
/// @param feet   where the shell ends below, by sector, counter-clockwise from +x; unknown where it is not seen [m]
/// @param voxel  to which points of the shell were thinned [m]
PeriodicFit fitFootHeights(const std::vector<double>& feet, double voxel, const FootWindow& window);

}  // namespace tank_datum
