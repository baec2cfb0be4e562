#pragma once

#include <vector>

#include "foot/shell_strip.h"

namespace tank_datum {

/// How high what noise leaves of a lip stands, and the standard error of that [m].
struct BlurredRise {
  double height = 0.0, error = 0.0;

  bool isSure() const { return height > 3.0 * error; }
};

/// What all strips show together; nothing where noise is narrower than lips.
BlurredRise blurredRise(const std::vector<ShellStrip>& strips, double reach);

/// How high a lip may be that noise blurs into the shell [m]: what is seen beside it then rises towards it, plainly
/// here or round the ring. Of what is seen nearest to the shell noise leaves half. A lip of the usual width may be
/// hidden whole, and nothing rises. 0 where noise is narrower than lips.
/// @param round_the_ring  what all strips show
double blurredLip(const ShellStrip& strip, const BlurredRise& round_the_ring, double reach);

}  // namespace tank_datum
