#pragma once

#include <optional>

#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The ring without the columns that show plates which stand out from the shell, as gussets of anchor chairs do: there
/// the shell goes on outwards, seen half as densely as on its outline, or more. Nothing where there are none, or where
/// a quarter of the ring is like that, as soil and plants are.
/// @param outline  of the shell
/// @param heights  above the foot that are looked at
std::optional<PolarRing> withoutGussets(const PolarRing& ring, const ShellOutline& outline, const Tank& tank,
                                        const ShellHeights& heights);

}  // namespace tank_datum
