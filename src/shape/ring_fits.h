#pragma once

#include "shape/out_of_plane.h"
#include "shape/ring_model.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// harmonicsOf and fitOutOfPlane with a model of the ring that is there already.
std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius, const RingModel& model);
OutOfPlane fitOutOfPlane(const std::vector<Station>& stations, double radius, const RingModel& model);

/// The highest wave of the ballot's regression: its half-wave is 20 ft.
int shortestWave(double radius);

}  // namespace tank_datum
