#pragma once

#include <vector>

#include "locate/sample_ladder.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The foot against azimuth. Shells that end above a shadow outnumber, at times, those seen to their foot, but nothing
/// of a shell lies below it: the fit starts from the lowest fifth, and takes what agrees with it.
/// @param window  how far from the fit a foot may lie [m]
PeriodicFit fitFootHeights(const std::vector<double>& azimuths, const std::vector<double>& feet, double window);

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
