#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/locate/tank.h"
#include "tank_datum/setups/setups.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The foundation surface that the stations were fitted to, across the shell.
struct FoundationBand {
  double from, to;  ///< distances from the shell [m]
  double slope;     ///< outwards [m/m]
  double noise;     ///< of its points [m]

  /// How far off the stations' datum its points may lie [m]: by noise, by what the datum runs beside a station, and by
  /// what scans disagree.
  double tolerance(double reach) const;
};

/// What each setup has in each station: shares that sum to 1 over the setups, or to 0 where a station is not known.
struct SetupShares {
  Eigen::MatrixXd foundation, shell;  ///< [stations x setups], or [stations x 1] where one setup only has points
};

/// Counts the points of each setup in every station's window; an interpolated station has what the measured ones beside
/// it have.
/// @param center  about which the stations stand [m]
SetupShares setupShares(const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                        const Eigen::Vector2d& center, const FoundationBand& band);

/// What the setups' remaining errors do to the stations, as the shared part of their covariance: F = L^T J^T with J the
/// derivatives of the elevations by the setups' parameters and L L^T their covariance; rotated such that rows that move
/// no station by a micrometre can be left out.
Eigen::MatrixXd setupFactors(const SetupAgreement& agreement, const SetupShares& shares,
                             const std::vector<Station>& stations, double slope);

/// What the setups' remaining errors in plan do to the stations' radii from the centre of all [m]: standard errors.
std::vector<double> setupRadiusErrors(const SetupAgreement& agreement, const SetupShares& shares,
                                      const std::vector<Station>& stations);

/// What the setups' errors mean for the stations.
struct SharedErrors {
  StationCovariance covariance;                ///< of the stations' elevations
  std::vector<double> radius_errors;           ///< of the stations' radii, shared ones [m]
  std::vector<StationSetups> stations;         ///< of each that has an elevation
  std::vector<std::vector<std::size_t>> seen;  ///< by each setup: numbers of measured stations, rising
};

SharedErrors shareSetupErrors(const SetupAgreement& agreement, const std::vector<Station>& stations,
                              const SetupShares& shares, double slope);

/// The stations with what they share in their standard errors.
std::vector<Station> withSharedErrors(std::vector<Station> stations, const SharedErrors& shared);

}  // namespace tank_datum
