#pragma once

#include <functional>
#include <vector>

#include "scene.h"

namespace tank_datum::synth {

/// A scanner where it stands, with the grid of its rays.
struct ScanStation {
  /// Where a point is said to be: shifted and turned by the registration's error.
  Eigen::Vector3d registered(const Eigen::Vector3d& point) const;

  Eigen::Vector3d position;      ///< without the offset [m]
  int inside = -1;               ///< index of the tank it stands in
  double first_azimuth = 0.0;    ///< of column 0 [rad]
  double first_elevation = 0.0;  ///< of row 0 [rad]
  std::vector<int> columns;      ///< those in the field
  int rows = 0;
  RegistrationError registration;
};

std::vector<ScanStation> scanStations(const Scene& scene);

/// Direction of one ray of a station's grid.
Eigen::Vector3d rayDirection(const ScannerOptions& options, const ScanStation& station, int column, int row);

/// Rows of x, y, z, intensity with the scene's offset added.
using Rows = std::vector<double>;

/// Receives the next rows and the index of the station that measured them.
using RowVisitor = std::function<void(std::size_t station, const Rows& rows)>;

/// Counts of one simulated scan.
struct ScanSummary {
  std::uint64_t rays = 0, points = 0;
};

/// Simulates the scan station by station, column by column, in bounded memory. The rows and their order depend on the
/// options alone, not on the number of threads.
/// @param threads  0 = as many as the machine has
ScanSummary scanScene(const Scene& scene, const RowVisitor& visit, unsigned threads = 0);

}  // namespace tank_datum::synth
