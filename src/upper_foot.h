#pragma once

#include <optional>

#include "tank_datum/datum.h"

namespace tank_datum {

/// Of two datums the tank's: of a shell that stands on a narrow ringwall, or of one that steps back above its foot, as
/// upon a skirt. A datum that is refused or doubtful is none; and a shell that has a plate well below the step stands
/// on that.
/// @param upper  above the step
/// @param lower  where the wall ends
Datum upperOrLower(Datum upper, Datum lower);

/// Whether a radius is that of the face on which a tank may stand, rather than of its shell [m].
inline bool isOfFace(double radius, const Tank& upon) {
  return radius > upon.circle.radius + 0.5 * upon.ringwall_width;
}

/// A wall that stands out of the one above it [m].
struct WallStep {
  double width = 0, height = 0;
};

/// A step of which nothing says whether the shell begins there, or goes on behind what clads its lowest part; of no
/// height where there is none or something says so: a lip of which the step is no edge, a plate below it, a
/// foundation that goes on beyond it at some azimuths, or that few claddings are as thick.
/// @param upon  the tank on a narrow ringwall, if it may stand on one
WallStep stepInDoubt(const Datum& datum, const std::optional<Tank>& upon);

}  // namespace tank_datum
