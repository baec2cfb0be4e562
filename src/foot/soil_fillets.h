#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations upon a wide surface in arcs where the section bends up towards the shell by more than it does round the
/// ring: soil that ends within the reach. It lies in the shell's corner as a fillet does, and a line through all of it
/// is as steep as no station tells from a foundation. (A section bends so, too, where a crown comes nearer to the shell
/// than elsewhere; there the bend is its outer part's.)
/// @param kept  fits of the stations that stand
std::vector<bool> findFillets(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept);

}  // namespace tank_datum
