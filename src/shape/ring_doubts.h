#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What the datum may be beyond what its measured stations say, gap by gap. Where something was refused that may be the
/// datum nevertheless, the ring follows the one or the other, as likely as not. Where a bridge is less sure than the
/// measured stations make it, the ring is off along the whole gap by one normal deviate of what its errors exceed
/// theirs.
class RingDoubts {
 public:
  RingDoubts() = default;
  /// @param stations  in order round the ring; those with z_refused and those interpolated may be in doubt
  /// @param expected  elevation of the datum at each of them, as the measured ones say [m]
  /// @param sigmas    standard errors of that [m]
  RingDoubts(const std::vector<Station>& stations, const Eigen::VectorXd& expected, const Eigen::VectorXd& sigmas);

  bool empty() const { return gaps_.empty(); }

  /// What each gap adds to the datum at azimuths [places x gaps] [m].
  Eigen::MatrixXd at(const Eigen::VectorXd& azimuths) const;
  /// The same as coefficients 1, cos t, sin t, cos 2t, ... up to an order [coefficients x gaps] [m].
  Eigen::MatrixXd waves(int order) const;
  /// What part of its addition each gap has: 1 or 0 where something was refused, a normal deviate elsewhere
  /// [gaps x draws].
  Eigen::MatrixXd drawn(int draws, std::uint64_t seed) const;

 private:
  /// Values straight from one place to the next, none outside.
  struct Gap {
    double first;                ///< azimuth of the station before it [rad]
    std::vector<double> ahead;   ///< azimuth from there on, rising [rad]
    std::vector<double> values;  ///< [m]; none at both ends
    bool refused;                ///< whether they are of what was refused

    double at(double azimuth) const;
  };
  void add(const std::vector<Station>& stations, const std::vector<double>& values, bool refused);

  std::vector<Gap> gaps_;
};

}  // namespace tank_datum
