#pragma once

#include "hit.h"
#include "tank_shape.h"

namespace tank_datum::synth {

/// The shell's outer face, for scanners outside.
void traceShell(const TankShape& tank, const TankRay& local, int owner, Hit& hit);

/// Its inner face, for scanners inside.
void traceInnerShell(const TankShape& tank, const TankRay& local, int owner, Hit& hit);

/// Cone or dome, and for scanners inside a floating roof from below.
void traceRoof(const TankShape& tank, const TankRay& local, bool inside, int owner, Hit& hit);

}  // namespace tank_datum::synth
