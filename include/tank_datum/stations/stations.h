#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"

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

/// Why a station is not measured.
enum class Unmeasured {
  None,          ///< it is; or the paper's method has no edge points there
  NoShell,       ///< the shell is not seen above it
  Hidden,        ///< too few points of the surface beside it
  OtherSurface,  ///< what is seen there is not the surface on which its neighbours lie, or no foot: the shell goes on
                 ///< below
  OffCircle,     ///< what stands there is not the shell
  ShellBelow,    ///< the shell is seen to go on below the level that its neighbours give
};

/// The name used in files: "", "no_shell", "hidden", "other_surface", "off_circle", "shell_below".
const char* nameOf(Unmeasured reason);

/// The datum at one azimuth, as the stages at the foot find it.
struct StationDatum {
  double direction = kUnknown;  ///< counter-clockwise from +x [rad]
  StationFlag flag = StationFlag::Missing;
  Unmeasured reason = Unmeasured::None;
  double x = kUnknown, y = kUnknown, z = kUnknown;    ///< relative to the scan's origin [m]
  double sigma_z = kUnknown;                          ///< standard error of z [m]
  double radius = kUnknown, sigma_radius = kUnknown;  ///< distance from the centre and its standard error [m]
  std::optional<std::size_t> n_shell, n_foundation;   ///< points behind z; none with the paper's method
  double window = kUnknown;                           ///< arc along which the points behind z lie [rad]
  double z_refused = kUnknown;  ///< elevation here if what was refused in this gap is the datum nevertheless [m]
};

/// What the setups of the scanner have to do with a station.
struct StationSetups {
  std::optional<std::size_t> n_setups;  ///< setups that see it
  double sigma_setup = kUnknown;        ///< part of sigma_z that stations share through setups [m]
};

/// Where a station stands to the fitted plane.
struct StationTilt {
  double z_tilt = kUnknown;  ///< elevation of the plane here [m]
  double u = kUnknown;       ///< z - z_tilt [m]
};

/// The regression of a station's out-of-plane settlement.
struct StationBending {
  double u_fit = kUnknown, sigma_u_fit = kUnknown;          ///< trigonometric regression of u, its standard error [m]
  double curvature = kUnknown, sigma_curvature = kUnknown;  ///< second derivative of its bending along the shell [1/m]
};

/// A row of the result: what every stage found at one azimuth, put together.
struct Station : StationDatum, StationSetups, StationTilt, StationBending {
  double azimuth = kUnknown;  ///< as the user counts it, from zero_azimuth in the chosen direction [rad]
  double z_paper = kUnknown;  ///< the paper's B-spline [m]
};

/// Covariance of the stations' elevations z, in their order: C = diag(independent^2) + factors^T factors [m^2].
/// A row of `factors` is one error that stations share, such as the height of a scanner's setup: what one standard
/// deviation of it does to each station.
struct StationCovariance {
  Eigen::VectorXd independent;  ///< [n] standard error of each station's own [m]; NaN where it is not known
  Eigen::MatrixXd factors;      ///< [m x n] shared errors, m = 0 when there are none [m]; 0 where a station is missing

  bool empty() const { return independent.size() == 0; }
  /// Standard error of one station's elevation, own and shared together [m].
  double sigma(std::size_t station) const;
  /// C of the stations named, in that order [m^2].
  Eigen::MatrixXd dense(const std::vector<std::size_t>& stations) const;
};

/// A quantity at a place round the tank.
struct PlacedValue {
  double value = kUnknown;    ///< [m], or [m/m] of a slope
  double sigma = kUnknown;    ///< its standard error, unknown when the stations' are
  double azimuth = kUnknown;  ///< [rad]
};

/// 95 % interval of a figure; unknown when the errors are.
struct Interval95 {
  double low = kUnknown, high = kUnknown;

  bool known() const { return low <= high; }
};

}  // namespace tank_datum
