#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Where shell and datum are at a station; NaN where no station knows [m].
struct StationLevel {
  double radius, z;
};

/// Where a point lies beside the foot.
struct FootPlace {
  std::size_t cell;
  double azimuth;  ///< [rad]
  double d, h;     ///< from the shell towards the scanner's side, and above the datum; NaN where no station knows [m]
};

/// Equal cells of azimuth round the tank, the stations standing in the middle of some of them.
class StationCells {
 public:
  explicit StationCells(const std::vector<Station>& stations);

  std::size_t count() const { return levels_.size(); }
  double step() const { return step_; }  ///< [rad]
  std::size_t cellOf(double direction) const;

  /// @param center  about which the stations stand [m]
  FootPlace placeOf(const Eigen::Vector3d& point, const Eigen::Vector2d& center, Side side) const;

  /// Radius and elevation of the nearest station with both.
  const StationLevel& level(std::size_t cell) const { return levels_[cell]; }

 private:
  double first_, step_;
  std::vector<StationLevel> levels_;
};

}  // namespace tank_datum
