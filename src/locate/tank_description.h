#pragma once

#include "locate/sample_ladder.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

constexpr double kLeastFoundation = 0.25;  ///< share of the shell's azimuths at which one is seen beside it

/// Looks at points around a known circle: foot, side, coverage, height.
/// @param points  of the sample that shows the circle, or those that it was thinned from
/// @param rms     of the shell about the circle [m]
/// @param least   share of the shell's azimuths at which a foundation must be seen beside it; or it is seen in one arc,
///                of 30 degrees for kLeastFoundation and as much wider as the share is larger
/// @param given   whether the circle is the user's, who knows which wall is the shell: it is not left for another
Tank describe(const Points& points, const Sample& sample, const Circle& circle, double rms,
              double least = kLeastFoundation, bool given = false);

}  // namespace tank_datum
