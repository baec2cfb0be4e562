#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tank_datum/movement.h"

namespace tank_datum {

/// A station of the current survey measured in both.
struct MatchedStation {
  std::size_t station = 0;  ///< its index in the current survey
  double direction = 0.0;   ///< in the baseline's frame [rad]
  double dz = 0.0;          ///< current less baseline [m]
  double sigma = 0.0;       ///< from both sigmas [m]
  double slope = 0.0;       ///< of the baseline's elevation along the direction [m/rad]
};

/// The stations measured in both when the current survey is turned by `offset` [rad], by direction.
std::vector<MatchedStation> matchStations(const Epoch& baseline, const Epoch& current, double offset);

/// Takes a common height or tilt, fitted with weights 1/sigma^2, from dz.
void removeCommon(std::vector<MatchedStation>& stations, Removal removal);

struct AzimuthOffset {
  double value = 0.0;  ///< [rad]
  double sigma = 0.0;  ///< its standard error [rad]
};

/// The turn of the current survey at which the shapes agree best.
/// @throws Error (Option) when the shape does not single out one turn
AzimuthOffset estimateOffset(const Epoch& baseline, const Epoch& current, const MovementOptions& options);

}  // namespace tank_datum
