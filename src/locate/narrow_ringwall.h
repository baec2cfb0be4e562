#pragma once

#include <optional>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The tank whose shell stands on a ringwall, a plinth or a kerb that is too narrow to be told from the shell in the
/// sample in which tanks are looked for: its foot, its circle and what it stands on, where the wall in the ring steps
/// back by 20 to 110 mm over most of the azimuths that tell. Nothing of a tank that is seen from inside, of one whose
/// ringwall is known, and where the wall goes straight down.
std::optional<Tank> onNarrowRingwall(const Ring& ring, const Tank& tank);

}  // namespace tank_datum
