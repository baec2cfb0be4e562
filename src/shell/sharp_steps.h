#pragma once

#include <vector>

#include "foot/polar_ring.h"

namespace tank_datum {

/// A place at which a row of the shell steps from one level to another, as at the edge of a plate put upon it.
struct SharpStep {
  double azimuth;  ///< [rad]
  double height;   ///< of what is beyond it, counter-clockwise, over what is before it [m]
};

/// The sharp steps of a row: not the turns of a dent or of a peaked weld, however steep.
/// @param ring    all points of the row
/// @param radius  of the shell, roughly [m]
/// @param noise   usual spread of its points [m]
std::vector<SharpStep> sharpSteps(const PolarRing& ring, double radius, double noise);

/// A place of a row.
struct RowPlace {
  double azimuth, half_width;  ///< [rad]
  double z, half_band;         ///< [m]
};

/// Whether the shell steps at a height, as at the upper edge of a plate put upon it.
bool stepsUpwards(const PolarRing& ring, const RowPlace& place, double noise);

}  // namespace tank_datum
