#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/datum.h"
#include "trust/shell_evidence.h"

namespace tank_datum {

/// Lengths of a shell survey and of the crop in multiples of a footUnit [m].
DatumOptions inUnits(DatumOptions options, double unit);

/// The turn that puts a shell that leans so upright.
Eigen::Matrix3d uprightTurn(const ShellLean& lean);

/// The scan turned about the tank's foot so that the shell, whose lean is known, stands upright.
Scan turnedUpright(const Scan& scan, const Datum& datum);

/// The tank with the circle of its foot. That of all its height stands beside it where the shell leans, and stations
/// about it lie beside their azimuths, on a foundation that climbs there once the shell is turned upright.
Tank onItsFoot(Tank tank, const ShellEvidence& evidence);

/// What the stages at the foot give.
struct FootResult {
  std::vector<std::int32_t> edge;  ///< of the ring's points for the search, in order round the tank
  Points edge_points;              ///< those points
  ClosedSpline curve;              ///< through them
  Circle circle;                   ///< about whose centre the stations stand
  Refined refined;                 ///< not valid with Method::Paper
  std::vector<Station> stations;
  std::string note;  ///< why there is no curve through edge points
};

/// The frame in which the stages at the foot work. They think in metres, which are footUnit long, and of a shell that
/// stands upright: a shell that leans by more than a quarter of a degree, in a scan that was not level or by itself, is
/// turned upright about its foot, and what was measured is turned back.
class FootFrame {
 public:
  FootFrame(const Tank& tank, const ShellLean& lean);

  /// Whether it is the scan's frame.
  bool isScans() const { return unit_ == 1.0 && !turned_; }
  bool isTurned() const { return turned_; }

  Ring into(Ring ring) const;
  Tank into(Tank tank) const;

  /// Puts curve, stations and what was refined back into the scan's frame.
  void backFrom(FootResult& foot) const;

 private:
  Eigen::Vector3d in(const Eigen::Vector3d& p) const { return (turn_ * (p - foot_) + foot_) / unit_; }
  Eigen::Vector3d out(const Eigen::Vector3d& p) const { return turn_.transpose() * (p * unit_ - foot_) + foot_; }
  void turnBack(Station& station, const Circle& circle) const;

  double unit_ = 1.0;
  bool turned_ = false;
  Eigen::Vector2d slope_ = Eigen::Vector2d::Zero();     ///< of the shell's axis [m/m]
  Eigen::Vector3d foot_ = Eigen::Vector3d::Zero();      ///< about which it is turned [m]
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();  ///< the shell's axis to the vertical
};

}  // namespace tank_datum
