#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// How far the stations stand above where the shell is seen elsewhere, over how far that scatters about its plane: the
/// middle one of them. A datum lies nowhere above what is seen of the shell, so that of a foot of which a part is
/// measured, the rest hidden, this is negative or small, whatever its tilt and its waves; of heaps against a shell
/// whose foot is hidden elsewhere it is not. NaN where the shell is seen at fewer stations that do not stand than there
/// are.
/// @param fits  not valid where a station does not stand
double raisedAboveRest(const Foot& foot, const std::vector<FootFit>& fits);

}  // namespace tank_datum
