#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "tank_datum/edge/edge_points.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// A direction as stations are counted, in [0, 2 pi) [rad].
double azimuthOf(double direction, const StationOptions& options);

/// The direction of an azimuth, in [0, 2 pi) [rad].
double directionOf(double azimuth, const StationOptions& options);

/// Stations with their azimuths and nothing else.
std::vector<Station> emptyStations(const StationOptions& options);

/// Stations with what a stage found of each put in; unchanged where it found nothing at all.
template <typename Part>
std::vector<Station> withParts(std::vector<Station> stations, const std::vector<Part>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) static_cast<Part&>(stations[i]) = parts[i];
  return stations;
}

/// Whether a station's gap is in doubt: what was refused in it may be the datum.
inline bool isInDoubt(const StationDatum& station) { return std::isfinite(station.z_refused); }

/// The same, but for those where the shell is seen below, which are none that a heave lifts.
inline bool mayBeHeaved(const StationDatum& station) {
  return isInDoubt(station) && station.reason != Unmeasured::ShellBelow;
}

/// Flags of stations by a list of support: measured where supported, interpolated in gaps up to options.longest_bridge
/// that have support on both sides, missing else.
std::vector<StationFlag> flagsOf(const std::vector<bool>& supported, const StationOptions& options);

/// Gives the interpolated stations of a refined datum their z, radius and standard errors: a parabola through the
/// measured stations around the gap, weighted by their standard errors and by what a curve of the bend sigma_bend may
/// depart by as far away as they stand. The error grows into the gap by that.
/// @param center      about which the stations stand [m]
/// @param sigma_bend  standard deviation of the datum's second derivative along the shell [1/m]
std::vector<StationDatum> bridgeGaps(const std::vector<StationDatum>& stations, const Eigen::Vector2d& center,
                                     double sigma_bend);

/// Step 6 of the method: the spline's elevation at every station that has edge points within half a station's spacing
/// or half a degree, whichever is more; z, radius and place of the measured and interpolated ones.
std::vector<StationDatum> samplePaperCurve(const std::vector<Station>& stations, const ClosedSpline& curve,
                                           const EdgePoints& edge, const StationOptions& options);

}  // namespace tank_datum
