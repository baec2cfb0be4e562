#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// How many strips beside the shell show far fewer points of a surface than those farther out; 0: none.
/// @param points  of the surface in strips of equal width, from the shell outwards
std::size_t thinStrips(const std::vector<std::size_t>& points);

/// How far from the shell the surface that stations lie on is hidden [m]; 0 where it is seen up to the shell. Rays meet
/// a surface as densely beside the shell as farther out. A crown that stands before the shell hides what lies between:
/// beams that graze its edge leave few points there.
/// @param levels  elevation of every station [m]
double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels);

}  // namespace tank_datum
