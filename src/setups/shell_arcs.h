#pragma once

#include <cstddef>
#include <vector>

#include "setups/setup_ring.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

constexpr double kTripodsApart = 0.5;  ///< places of two setups, at least [m]

/// Points on the shell above its foot, by arc of SetupRing.
using ShellArcs = std::vector<std::size_t>;

/// Those of all points of a ring.
ShellArcs shellArcs(const Ring& ring, const Tank& tank);

/// Those of each setup.
/// @param reach  of the ring [m]
std::vector<ShellArcs> shellArcsOfSetups(const SetupRing& ring, const Tank& tank, double reach, std::size_t setups);

/// Whether a shell's points reach farther round it than one setup sees: from outside never half of it.
bool isSeenBySeveral(const ShellArcs& arcs, const Tank& tank);

/// Whether parts meet at their borders only, as tiles of one cloud do; what none or one of them shows tells nothing.
/// Setups that hardly overlap do it where both see the shell at a grazing angle, by few points.
/// @param parts  each one's
bool areTiles(const std::vector<ShellArcs>& parts);

/// Whether files or labels cannot be setups: one of them shows more of the shell than a setup sees, or they are
/// tiles. (Tiles have no places of their own that a scanner stood at.)
/// @param setups  of each
/// @param apart   whether files say of all that they stood apart
bool areNoSetups(const std::vector<ShellArcs>& setups, const Tank& tank, bool apart);

}  // namespace tank_datum
