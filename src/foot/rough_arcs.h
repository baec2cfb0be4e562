#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations in arcs whose points scatter far more than the surface's do round the ring, and more than noise can make
/// them: soil and rubble that lie on it, which thin layers show by nothing else. Two scans that disagree put points on
/// two levels, each as smooth as elsewhere: no such arc is rough.
/// @param own  of stations and their neighbours, where they stand
std::vector<bool> findRoughArcs(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& own);

/// The pass without their fits; what they lie on may be the datum nevertheless. It is the last that is left out: what
/// the passes made of the section and of the other stations does not depend on it.
FootPass withoutRoughArcs(const Foot& foot, FootPass pass);

}  // namespace tank_datum
