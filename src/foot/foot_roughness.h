#pragma once

#include <vector>

#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

/// The points of a fit, and the fit through them.
struct FittedPoints {
  std::vector<FootPoint> points;
  FootFit fit;
};

/// What a surface's roughness, which neighbouring points share, adds to the error of its level: from how far parts of
/// the band lie off the fits, beyond what points that err alone do (a variance component).
/// @param fits     all round; those of few points tell nothing
/// @return variance of a level over the points' own number times its formal variance: sigma^2 of a fit grows by this
///         times n (sigma / noise)^2 [m^2]
double sharedRoughness(const std::vector<FittedPoints>& fits, const FootProfile& profile);

}  // namespace tank_datum
