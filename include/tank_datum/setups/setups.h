#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"

namespace TANK_DATUM_API tank_datum {

/// What is done with a setup that does not agree with the others, once it is named.
enum class BadSetups {
  Free,  ///< its correction comes from the overlaps alone: no prior draws it, and it draws no other setup
  Drop,  ///< its points are left out where another setup sees the foot too
  Keep,  ///< treated as the others
};

/// The name used at the command line and in files: "free", "drop", "keep".
const char* nameOf(BadSetups bad);

struct SetupOptions {
  double error = 0.0;  ///< prior standard deviation of a setup's dz, dx and dy [m]; 0: estimated from the overlaps
  double tilt = 0.0;   ///< prior standard deviation of a setup's tilt about each axis [rad]; 0: estimated
  BadSetups bad = BadSetups::Free;
  std::map<std::string, Eigen::Vector3d> origins;  ///< where setups stood, by name, in the scan's own frame [m]
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const SetupOptions& options);

/// A small rigid motion of a setup's points about its origin: up by dz, turned such that z rises by tilt_x along x and
/// by tilt_y along y, and moved by dx, dy.
struct SetupMotion {
  double dz = 0.0;                    ///< [m]
  double tilt_x = 0.0, tilt_y = 0.0;  ///< [rad]
  double dx = 0.0, dy = 0.0;          ///< [m]

  static constexpr int kParameters = 5;
  using Vector = Eigen::Matrix<double, kParameters, 1>;
  static SetupMotion of(const Vector& v) { return {v[0], v[1], v[2], v[3], v[4]}; }
  Vector vector() const { return (Vector() << dz, tilt_x, tilt_y, dx, dy).finished(); }

  /// The point moved.
  Eigen::Vector3d operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& origin) const;
};

enum class SetupVerdict {
  Single,     ///< the only setup: there is nothing to compare
  Unseen,     ///< no point near the datum
  Alone,      ///< sees no arc that another setup sees: its error stays in the covariance
  Agrees,     ///< within what its sigmas say
  Adjusted,   ///< off by more than the noise, and corrected
  Bad,        ///< off by far more than the others are: named
  Duplicate,  ///< the same points as an earlier setup
};

/// The name used in files: "single", "unseen", "alone", "agrees", "adjusted", "bad", "duplicate".
const char* nameOf(SetupVerdict verdict);

/// One setup of the scanner.
struct Setup {
  std::string name;
  bool origin_known = false;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< its motions turn about it, relative to the scan's origin [m];
                                                     ///< the middle of its points where it is not known
  double origin_refused = 0.0;    ///< how far from its points the file says that it stood, where that
                                  ///< is too far to be true [m]; else 0
  std::size_t points = 0;         ///< in the ring
  std::size_t stations = 0;       ///< that it sees
  std::vector<std::size_t> seen;  ///< their numbers, rising
  SetupMotion correction;         ///< what its points were moved by
  SetupMotion sigma;              ///< standard error of that
  double rms_before = kUnknown;   ///< its foundation against the other setups' [m]
  double rms_after = kUnknown;    ///< the same after the correction [m]
  SetupVerdict verdict = SetupVerdict::Single;
};

/// The sigmas that the setups' errors are taken to have before the overlaps are looked at.
struct SetupSpread {
  double height = 0.0, tilt = 0.0, plan = 0.0;  ///< of dz [m], of a tilt [rad], of dx and of dy [m]
};

/// Files or labels that are parts of one setup: tiles or shares of a cloud whose labels name the setups, or shares that
/// show the same of the shell.
enum class SplitSetups { None, ByLabel, ByDensity };

/// How the setups of a scan agree.
struct SetupAgreement {
  std::vector<Setup> setups;
  SetupSpread spread;             ///< that the setups were adjusted with
  SetupSpread given;              ///< by the options; zeros where not
  bool height_estimated = false;  ///< whether spread.height comes from the overlaps; else given or assumed
  bool tilt_estimated = false;    ///< whether spread.tilt does
  bool plan_estimated = false;    ///< whether spread.plan does
  bool no_setups = false;         ///< files or labels can be none and were taken together: wholes, or tiles of one
  bool too_many = false;          ///< more files or labels than are told apart, and were taken together
  SplitSetups split = SplitSetups::None;  ///< whether files or labels that are parts of one setup were joined
  bool by_order = false;                  ///< told apart by the order of the points, not by files or labels
  double rms_before = kUnknown, rms_after = kUnknown;  ///< over all [m]
  double groups_apart = 0.0;        ///< where the setups' heights are of two groups: what these differ by [m]; else 0
  std::vector<std::size_t> higher;  ///< numbers of the setups of the higher group, rising
  Eigen::MatrixXd covariance;       ///< of all setups' motions, in order, that are left unknown; empty for one setup
  std::size_t repeated_points = 0;  ///< points of the ring left out because they were there already
  double unlabelled_discrepancy =
      0.0;                    ///< between two scans merged without labels, where it shows in the residuals [m]
  double merged_sigma = 0.0;  ///< of the height of each of several scans merged without labels that nothing tells apart
                              ///< [m]; 0 of one scan

  bool adjusted() const { return covariance.size() > 0; }
  SetupSpread errorsOfOne() const;     ///< of each of several setups before they are adjusted; zeros of one
  SetupSpread errorsOfPoints() const;  ///< the same where points are not moved: at least what bad ones are off by
  std::size_t seeing() const;          ///< setups that see stations
  double radiusError() const;          ///< that their places leave in a tank's radius, which no overlap shows [m]
};

}  // namespace tank_datum
