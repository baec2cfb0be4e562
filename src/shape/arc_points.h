#pragma once

#include <vector>

#include "stations/ring_series.h"
#include "tank_datum/shape/analysis.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The points whose zero crossings bound the settlement arcs: the stations, or of more than 64 those of the regression
/// or means of the stations round survey points.
class ArcPoints {
 public:
  ArcPoints(const std::vector<Station>& stations, double radius);

  /// U at the points, as surveyed.
  const std::vector<RingValue>& values() const { return values_; }
  bool ofRegression() const { return of_regression_; }

  /// U at the points from U at the known stations, one number each, in order: how a simulated survey is reduced.
  std::vector<double> reduce(const double* u) const;

  /// The arcs of values at the points.
  std::vector<SettlementArc> arcsOf(const std::vector<RingValue>& values) const;
  std::vector<SettlementArc> arcsOf(const std::vector<double>& u) const;

 private:
  double radius_;
  bool of_regression_ = false;
  std::vector<RingValue> values_;
  std::vector<std::vector<std::size_t>> members_;  ///< of each point, among the known stations; empty: itself
};

}  // namespace tank_datum
