#pragma once

#include "foot/foot_state.h"

namespace tank_datum {

constexpr double kWideSlope = 0.1;  ///< of pads and floors, before they are looked at [m/m]

/// The slope of a wide foundation surface round the tank, from windows ten degrees wide; soil would tilt its harmonic.
/// Where one row of the scan creeps out across a window, its curve and the surface's slope cannot be told apart, and
/// what rays that graze leave of the roughness tilts it by more than the points' scatter says; all windows of one row
/// alike.
void learnWide(const Foot& foot, const FootElevations& elevations, const FootSections& sections, FootPriors& priors);

}  // namespace tank_datum
