#pragma once

#include <optional>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

constexpr double kNarrowestFace = 0.02;  ///< that a face stands out by: more than plates and welds do [footUnit]
constexpr double kWidestFace = 0.11;     ///< wider ones are told in the sample [footUnit]

/// Whether a tank's ringwall may be too narrow to be told from the shell in the sample in which tanks are looked for.
inline bool mayStandOnNarrowRingwall(const Tank& tank) {
  return tank.side == Side::Outside && !tank.standsOnRingwall();
}

/// The tank whose shell stands on a ringwall, a plinth or a kerb that is so narrow: its foot, its circle and what it
/// stands on, where the wall in the ring or above it steps back by 20 to 110 mm over most of the azimuths that tell.
/// Nothing of a tank of which mayStandOnNarrowRingwall() does not hold, and where the wall goes straight down.
/// @param above  points of the wall from the ring's upper end on, up to where a ringwall's face may end
std::optional<Tank> onNarrowRingwall(const Ring& ring, const Points& above, const Tank& tank);

}  // namespace tank_datum
