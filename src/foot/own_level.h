#pragma once

#include <cstddef>

#include "foot/foot_state.h"

namespace tank_datum {

/// The surface that a station's own points lie on at whatever level, for one that does not show the surface where its
/// neighbours let it be looked for: a heave, or what lies upon the foot. Not valid where few points lie on one surface,
/// or where they scatter more than those of the foot do.
FootFit fitAtOwnLevel(const Foot& foot, std::size_t station, const FootPass& pass);

}  // namespace tank_datum
