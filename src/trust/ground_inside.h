#pragma once

#include "tank_datum/locate/tank.h"
#include "trust/shell_evidence.h"

namespace tank_datum {

/// Over how many azimuths ground is seen inside of a shell's circle and no wall of it, for each at which its wall is: a
/// shell is opaque, and goes on along its circle where it is not seen. NaN of one that is seen from inside or not
/// known.
double groundInside(const Ring& ring, const Tank& tank, const ShellEvidence& shell);

}  // namespace tank_datum
