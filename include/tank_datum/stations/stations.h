#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/edge/centre_filter.h"
#include "tank_datum/fit/spline.h"

namespace TANK_DATUM_API tank_datum {

struct StationOptions {
  int count = 360;                              ///< stations round the tank, at least 8
  double zero_azimuth = 0.0;                    ///< where station 0 is, counter-clockwise from +x seen from above [rad]
  bool clockwise = false;                       ///< which way they run
  double longest_bridge = 0.17453292519943295;  ///< gaps up to this are bridged by the curve [rad], 10 degrees
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const StationOptions& options);

enum class StationFlag {
  Measured,
  Interpolated,  ///< in a short gap, bridged by the curve from support on both sides
  Missing,       ///< nothing is known here: z and what follows are NaN
};

/// The name used in files: "measured", "interpolated", "missing".
const char* nameOf(StationFlag flag);

/// The datum at one azimuth.
struct Station {
  double azimuth = kUnknown;    ///< as the user counts it, from zero_azimuth in the chosen direction [rad]
  double direction = kUnknown;  ///< counter-clockwise from +x [rad]
  double x = kUnknown, y = kUnknown, z = kUnknown;    ///< relative to the scan's origin [m]
  double sigma_z = kUnknown;                          ///< standard error of z [m]
  double radius = kUnknown, sigma_radius = kUnknown;  ///< distance from the centre and its standard error [m]
  std::optional<std::size_t> n_shell, n_foundation;   ///< points behind z; none with the paper's method
  double window = kUnknown;                           ///< arc along which the points behind z lie [rad]
  std::optional<std::size_t> n_setups;                ///< setups of the scanner that see it
  double sigma_setup = kUnknown;                      ///< part of sigma_z that stations share through setups [m]
  StationFlag flag = StationFlag::Missing;
  double z_paper = kUnknown;                                ///< the paper's B-spline [m]
  double z_tilt = kUnknown;                                 ///< the fitted plane here [m]
  double u = kUnknown;                                      ///< z - z_tilt [m]
  double u_fit = kUnknown, sigma_u_fit = kUnknown;          ///< trigonometric regression of u, its standard error [m]
  double curvature = kUnknown, sigma_curvature = kUnknown;  ///< second derivative of its bending along the shell [1/m]
};

/// Stations with their azimuths and nothing else.
std::vector<Station> emptyStations(const StationOptions& options);

/// Flags stations by a list of support: measured where supported, interpolated in gaps up to options.longest_bridge
/// that have support on both sides, missing else.
void flagGaps(std::vector<Station>& stations, const std::vector<bool>& supported, const StationOptions& options);

/// Gives the interpolated stations of a refined datum their z, radius and standard errors: a parabola through the
/// measured stations around the gap, weighted by their standard errors. The error grows into the gap by what a curve
/// of the bend sigma_bend may do there.
/// @param center      about which the stations stand [m]
/// @param sigma_bend  standard deviation of the datum's second derivative along the shell [1/m]
void bridgeGaps(std::vector<Station>& stations, const Eigen::Vector2d& center, double sigma_bend);

/// Step 6 of the method: the spline's elevation at every station that has edge points within half a station's spacing
/// or half a degree, whichever is more. Fills z_paper of measured and interpolated stations, their flags, and z,
/// radius and sigmas from the curve.
void samplePaperCurve(std::vector<Station>& stations, const ClosedSpline& curve, const EdgePoints& edge,
                      const StationOptions& options);

}  // namespace tank_datum
