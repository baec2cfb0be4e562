#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Of half a step: half the window of a station and those beside it. Each point counts for as many stations.
constexpr double kWithNeighbours = 3.0;

/// The surface at a station as its points lie, whatever its slope is known to be.
/// @param half_width  of the window that is looked at [rad]
FootFit ownFit(const Foot& foot, std::size_t station, const FootPass& pass, double half_width);

/// Whether points rise to the shell as no foundation does, which a fit that is told the slope does not show: a heap of
/// soil. (They fall to it where few rows of the scan cross the lip: range noise moves a row's points along their rays.)
/// @param own  ownFit() of the station
bool isHeap(std::size_t station, const FootPriors& priors, const FootFit& own);

/// The same of half the window that a station is fitted in.
bool isHeapInHalf(const Foot& foot, std::size_t station, const FootPass& pass);

/// Whether what a station shows between the shell and its surface is the slope of a heap whose foot the surface is
/// taken for: most of those points lie higher than it, on a line that falls to it. (What stands before a shell, or a
/// pipe along it, is no line.)
bool isHeapBefore(const Foot& foot, std::size_t station, const FootPass& pass);

/// Whether the points of stations that stand rise to the shell as those of no lip do, all together: on sparse feet none
/// of them tells by itself.
/// @param own  of stations and their neighbours, where they stand
bool areHeaps(const std::vector<FootFit>& own, const FootPriors& priors);

/// Stations upon a lip in arcs whose points rise to the shell more steeply than the lip is known to, all together: thin
/// soil that no station tells from its own noise.
/// @param own  of stations and their neighbours, where they stand
std::vector<bool> findHeapedArcs(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own);

/// Stations upon a wide surface beside a heap that do not tell whether they lie on it too: no station in between shows
/// the foundation, and of their own points one row of the scan is seen, or too few for a slope. A row lies in the plane
/// of its rays, whatever the surface does, and so scatters less than points of the surface do elsewhere.
/// @param own    of stations and their neighbours, where they stand
/// @param heaps  stations that lie on heaps by themselves
std::vector<bool> findHeapsGoingOn(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own,
                                   const std::vector<bool>& heaps);

/// A few stations far from all others, which cannot be told by their elevation: whether they lie on soil, by a slope
/// that the foundation does not have.
/// @param own  of stations and their neighbours, where they stand
std::vector<bool> findStrangeIslands(const Foot& foot, const FootPriors& priors, const std::vector<FootFit>& own);

}  // namespace tank_datum
