#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Points on the shell above its foot, by setup and arc of SetupRing.
std::vector<std::vector<std::size_t>> shellArcs(const Ring& ring, const Tank& tank);

/// Whether a shell's points reach farther round it than one setup sees: from outside never half of it.
/// @param arcs  of shellArcs()
bool isSeenBySeveral(const std::vector<std::size_t>& arcs, const Tank& tank);

/// Whether files or labels cannot be setups: one of them shows more of the shell than a setup sees, or they meet at
/// their borders only, as tiles of one cloud do.
/// @param arcs  shellArcs() of each
bool areNoSetups(const std::vector<std::vector<std::size_t>>& arcs, const Tank& tank);

}  // namespace tank_datum
