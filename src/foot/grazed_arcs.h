#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations in arcs where few points lie between the shell and the edge of what lies higher farther out, and rise
/// towards it: beams that graze the edge leave them, on the line from there to the shell. A lip that is seen before a
/// crown has as many points as any surface, or is level.
/// @param kept  fits of the stations that stand
std::vector<bool> findGrazedArcs(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept);

}  // namespace tank_datum
