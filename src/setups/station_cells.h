#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Where shell and datum are at a station; NaN where no station knows [m].
struct StationLevel {
  double radius, z;
};

/// Equal cells of azimuth round the tank, the stations standing in the middle of some of them.
class StationCells {
 public:
  explicit StationCells(const std::vector<Station>& stations);

  std::size_t count() const { return levels_.size(); }
  double step() const { return step_; }  ///< [rad]
  std::size_t cellOf(double direction) const;

  /// Radius and elevation of the nearest station with both.
  const StationLevel& level(std::size_t cell) const { return levels_[cell]; }

 private:
  double first_, step_;
  std::vector<StationLevel> levels_;
};

}  // namespace tank_datum
