#pragma once

#include "stations/ring_rows.h"

namespace tank_datum {

/// Rows of the height between two places of the ring that are `arc` apart, over that arc [m/m]. Between straight lines
/// it is largest from or to a station.
RingRows slopeRows(const RingSeries& series, double radius, double arc);

/// Half of the largest height between any two places at most `arc` apart on the ring that is drawn straight from
/// station to station: it is between two stations, or between a station and the place `arc` from it.
class LevelWithin {
 public:
  LevelWithin(const RingSeries& series, double radius, double arc);

  /// Whether no two places are so close.
  bool empty() const { return !pairs_ && edges_.empty(); }

  /// Of plain numbers, one per value of the series; in time that grows with their number alone.
  double largest(const double* values) const;

  /// Of the values of the series, with its standard error and the middle between the two places.
  PlacedValue largest(const std::vector<RingValue>& values) const;

 private:
  /// Places of the largest and the smallest value of a window, of which the range is the largest [index].
  struct Range {
    std::size_t highest = 0, lowest = 0;
    double half = 0.0;
  };
  template <typename Value>
  Range widest(Value value) const;

  std::vector<std::size_t> ahead_;  ///< of each value: how many after it are within the arc
  bool pairs_ = false;              ///< whether any has one
  RingRows edges_;                  ///< between a value and the place `arc` from it
};

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
