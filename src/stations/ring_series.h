#pragma once

#include <optional>
#include <vector>

#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// A quantity at one azimuth and its standard error, NaN when unknown.
struct RingValue {
  double azimuth, value, sigma;
};

/// A quantity of the stations that have it, readable at any azimuth between neighbours.
class RingSeries {
 public:
  /// @param quantity  member of Station: z, u, u_fit
  /// @param sigma     member of Station with its standard error
  RingSeries(const std::vector<Station>& stations, double Station::*quantity, double Station::*sigma);

  const std::vector<RingValue>& values() const { return values_; }
  bool empty() const { return values_.empty(); }

  /// Linear between two neighbours with nothing missing between them; nothing in a gap. At a station its own.
  std::optional<RingValue> at(double azimuth) const;

 private:
  std::vector<RingValue> values_;
  double step_;  ///< the longest way between neighbours without a gap [rad]
};

}  // namespace tank_datum
