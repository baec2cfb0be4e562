#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

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

/// The covariance of stations that share nothing: sigma_z each.
StationCovariance independentCovariance(const std::vector<Station>& stations);

/// Whether the covariance is of so many stations, each shared error known at each of them: of default make it is of
/// any number.
bool fits(const StationCovariance& covariance, const std::vector<Station>& stations);

}  // namespace tank_datum
