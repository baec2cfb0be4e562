#pragma once

#include "random.h"
#include "scanner.h"

namespace tank_datum::synth {

/// Sends one ray, measures its range as a scanner would, and appends x, y, z, intensity when there is a return.
void measure(const Scene& scene, const ScanStation& station, const Eigen::Vector3d& direction, Random& random,
             Rows& rows);

/// Standard deviation of a range at the given cosine of the incidence angle [m].
double rangeSigma(const MeasurementOptions& options, double cosine);

}  // namespace tank_datum::synth
