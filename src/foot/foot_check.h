#pragma once

#include <functional>
#include <vector>

#include "foot/foot_fit.h"
#include "foot/foot_profile.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Whether what a station's fit lies on is the surface that meets the shell elsewhere, and not soil, gravel or a thing
/// standing there: it has the slope and the smoothness that it has all round, and the section goes on beyond it as it
/// does elsewhere (the ringwall a plate's thickness lower, a crown higher).
/// @param points  of the station, to the end of the section
bool isSameSurface(const std::vector<FootPoint>& points, const FootFit& fit, double prior_slope,
                   const FootProfile& profile);

/// A run of neighbouring stations without a step between them.
struct StepRun {
  std::vector<std::size_t> stations;
  double beside = 0;  ///< the lower elevation of the stations beside its ends [m]
};

/// Of each station whether it is to be dropped, and whether it lies in a dip of the datum between steps.
struct Steps {
  std::vector<bool> dropped, dips;
};

/// Stations that stand off their neighbours by a step. A steel shell cannot follow one, so the lesser part round the
/// tank is something else: while there are steps, the shortest run of stations between two of them is taken away.
/// @param fits     in order round the tank, not valid where nothing is measured
/// @param step     arc between stations [m]
/// @param is_foot  of a run that lies below those beside it, whether the shell is seen to go down to it: a dip
Steps findSteps(const std::vector<FootFit>& fits, double step, const std::function<bool(const StepRun&)>& is_foot);

/// Stations of islands among and beside which more lie on something else than stand, beside as far to either side as
/// they reach and no gap is bridged: nothing ties their elevation to the rest of the datum, so that what covers the
/// others may cover them. (Not of the island in which most stand.)
/// @param far  stations over which no gap is bridged
std::vector<bool> findOutnumberedIslands(const std::vector<Unmeasured>& reasons, std::size_t far);

/// Stations of islands of a few, between gaps that are not bridged: nothing says that what is seen there is the foot,
/// and not the edge of what hides the rest. (Not of the longest island.)
/// @param far  stations over which no gap is bridged
std::vector<bool> findLoneStations(const std::vector<Unmeasured>& reasons, std::size_t far);

/// The error that every station has on top of its standard error: the surface's own roughness and what no station knows
/// about. From the third differences of elevations one, two and three windows apart, which a datum without its shape
/// leaves at zero (the variance between laboratories of Mandel and Paule 1970, by a quantile instead of the mean
/// square).
/// @param fits   in order round the tank, the shape taken out of z
/// @param apart  stations between windows that share no points
/// @return standard deviation [m]; 0 when the standard errors explain all, or there are too few stations to tell
double commonSigma(const std::vector<FootFit>& fits, std::size_t apart);

}  // namespace tank_datum
