#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What the datum may be beyond what its measured stations say: in each gap in which something was refused that may be
/// the datum nevertheless, the ring follows the one or the other, as likely as not.
class RingDoubts {
 public:
  RingDoubts() = default;
  /// @param stations  in order round the ring; those with z_refused are in doubt
  /// @param expected  elevation of the datum at each of them, as the measured ones say [m]
  RingDoubts(const std::vector<Station>& stations, const Eigen::VectorXd& expected);

  bool empty() const { return gaps_.empty(); }

  /// What each gap adds to the datum at azimuths [places x gaps] [m].
  Eigen::MatrixXd at(const Eigen::VectorXd& azimuths) const;
  /// The same as coefficients 1, cos t, sin t, cos 2t, ... up to an order [coefficients x gaps] [m].
  Eigen::MatrixXd waves(int order) const;
  /// Of each gap 1 where a draw follows what was refused, else 0 [gaps x draws].
  Eigen::MatrixXd drawn(int draws, std::uint64_t seed) const;

 private:
  /// Values straight from one place to the next, none outside.
  struct Gap {
    double first;                ///< azimuth of the station before it [rad]
    std::vector<double> ahead;   ///< azimuth from there on, rising [rad]
    std::vector<double> values;  ///< [m]; none at both ends

    double at(double azimuth) const;
  };
  std::vector<Gap> gaps_;
};

}  // namespace tank_datum
