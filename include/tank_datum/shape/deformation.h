#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/station_covariance.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// Level of the datum over the stations whose z is known; NaN until computed.
struct Level {
  std::size_t measured = 0, interpolated = 0, missing = 0;
  double mean = kUnknown, min = kUnknown, max = kUnknown;  ///< [m]
  double min_azimuth = kUnknown, max_azimuth = kUnknown;   ///< as the user counts azimuths [rad]
  double range() const { return max - min; }
};

/// Highest, lowest, mean: from measured and interpolated stations.
Level levelOf(const std::vector<Station>& stations);

/// The paper's inclination: the largest difference of height between two ends of a diameter.
struct Antipodal {
  double max_h = kUnknown;     ///< h [m]
  double diameter = kUnknown;  ///< D, distance of the two stations in plan [m]
  double azimuth = kUnknown;   ///< of the higher end, as the user counts it [rad]
  double angle() const;        ///< alpha = atan(h / D) [rad]
};

/// The difference of height across every diameter, in the stations' order over half a turn: positive when the first
/// end is the higher one, NaN where an end is not known. Empty for an odd number of stations.
std::vector<double> antipodalHeights(const std::vector<Station>& stations);

/// The largest of them. An upper bound of the tilt: a bump or an error of one station counts in full.
Antipodal antipodalOf(const std::vector<Station>& stations);

/// z = mean + slope_x (x - x0) + slope_y (y - y0), fitted by least squares; NaN until fitted.
struct Tilt {
  double mean = kUnknown;                                          ///< elevation of the plane at the centre [m]
  Eigen::Vector2d gradient = Eigen::Vector2d::Constant(kUnknown);  ///< [m/m]
  double sigma_slope = kUnknown;                                   ///< standard error of the slope [m/m]
  double standard_error = kUnknown;                                ///< of the regression, what a station departs by [m]
  double direction = kUnknown;  ///< towards the highest point, as the user counts azimuths [rad]
  double freedom = 0.0;         ///< degrees of freedom behind sigma_slope; 0: errors given
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(kUnknown);  ///< of the gradient
  double r2 = kUnknown;                                              ///< share of the variance that the plane explains
  double p_value = kUnknown;  ///< F test on 2 and N - 3 degrees of freedom, see fitTilt

  bool valid() const { return gradient.allFinite(); }
  double slope() const { return gradient.norm(); }
};

/// Linear regression of z on 1, cos, sin (STANDARDS: tilt plane) over the measured stations, about `center`; at least
/// four of them. Of up to 64 stations all round by least squares, weighted by their standard errors; of more, or beside
/// a gap, along with the waves of the datum (RingModel), so that these do not pass for tilt. sigma_slope comes from the
/// errors of the stations, shared ones and those that neighbours show included, and from what waves leave unknown, not
/// from out-of-plane settlement. Beside a gap p_value is of a chi-square test. Fills z_tilt and u of every station
/// whose z is known.
/// @param covariance  of the stations; empty: sigma_z each
Tilt fitTilt(std::vector<Station>& stations, const Eigen::Vector2d& center, const StationOptions& options,
             const StationCovariance& covariance = {});

}  // namespace tank_datum
