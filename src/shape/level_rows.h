#pragma once

#include "stations/ring_rows.h"

namespace tank_datum {

/// Rows of the height between two places of the ring that are `arc` apart, over that arc [m/m]. Between straight lines
/// it is largest from or to a station.
RingRows slopeRows(const RingSeries& series, double radius, double arc);

/// Rows of half the height between any two places at most `arc` apart on the ring that is drawn straight from station
/// to station: the largest is between two stations, or between a station and the place `arc` from it.
RingRows levelRows(const RingSeries& series, double radius, double arc);

/// Height above the mean round the tank, each station counting for the arc that is nearest to it.
class MeanLevel {
 public:
  /// @param series    of z
  /// @param stations  that it is of
  MeanLevel(const RingSeries& series, const std::vector<Station>& stations);

  /// The value furthest from the mean.
  PlacedValue furthest(const std::vector<RingValue>& values) const;
  double furthest(const double* values) const;

 private:
  std::vector<double> shares_;  ///< of each value in the mean
};

}  // namespace tank_datum
