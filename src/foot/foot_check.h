#pragma once

#include <vector>

#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

/// Whether what a station's fit lies on is the surface that meets the shell elsewhere, and not soil, gravel or a thing
/// standing there: it has the slope and the smoothness that it has all round, and the section goes on beyond it as it
/// does elsewhere (the ringwall a plate's thickness lower, a crown higher).
/// @param points  of the station, to the end of the section
bool isSameSurface(const std::vector<FootPoint>& points, const FootFit& fit, double prior_slope,
                   const FootProfile& profile);

/// Stations that stand off their neighbours by a step. A steel shell cannot follow one, so the lesser part round the
/// tank is something else: while there are steps, the shortest run of stations between two of them is taken away.
/// @param fits  in order round the tank, not valid where nothing is measured
/// @param step  arc between stations [m]
/// @return true for the stations to drop
std::vector<bool> findSteps(const std::vector<FootFit>& fits, double step);

/// The error that every station has on top of its standard error: the surface's own roughness and what no station knows
/// about. From the third differences of elevations one, two and three windows apart, which a datum without its shape
/// leaves at zero (the variance between laboratories of Mandel and Paule 1970, by a quantile instead of the mean
/// square).
/// @param fits   in order round the tank, the shape taken out of z
/// @param apart  stations between windows that share no points
/// @return standard deviation [m]; 0 when the standard errors explain all, or there are too few stations to tell
double commonSigma(const std::vector<FootFit>& fits, std::size_t apart);

}  // namespace tank_datum
