#pragma once

#include <optional>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// A quantity at one azimuth and its standard error, NaN when unknown.
struct RingValue {
  double azimuth, value, sigma;
};

/// Where an azimuth lies among the values: (1 - share) of one and share of the next.
struct RingPlace {
  std::size_t before = 0, after = 0;
  double share = 0.0;
};

/// A quantity of the stations that have it, readable at any azimuth between neighbours.
class RingSeries {
 public:
  /// @param quantity  member of Station: z, u, u_fit
  /// @param sigma     member of Station with its standard error
  RingSeries(const std::vector<Station>& stations, double Station::*quantity, double Station::*sigma);

  const std::vector<RingValue>& values() const { return values_; }
  bool empty() const { return values_.empty(); }

  /// Between two neighbouring stations with nothing missing between them, nor so much as twice the stations' mean
  /// distance; nothing in a gap. At a station that station alone.
  std::optional<RingPlace> placeOf(double azimuth) const;

  /// Linear between the two.
  std::optional<RingValue> at(double azimuth) const;

  /// Whether nothing is missing between a value and the next.
  bool joined(std::size_t i) const { return joined_[i]; }

 private:
  std::vector<RingValue> values_;
  std::vector<bool> joined_;
};

/// The way from one azimuth ahead to another [rad], from 0 to a turn.
double turnAhead(double from, double to);

}  // namespace tank_datum
