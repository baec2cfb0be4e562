#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "stations/ring_series.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Figures that are linear in the values of a ring, such as differences of heights: one row each. The same rows give
/// the figures of a survey and of simulated ones.
class RingRows {
 public:
  /// A row that is the sum of weight * (value at place).
  /// @param azimuth  where it is said to be [rad]
  /// @param scale    what a value is multiplied by to compare it with those of other rows
  void add(double azimuth, const std::vector<std::pair<RingPlace, double>>& parts, double scale = 1.0);

  std::size_t size() const { return azimuths_.size(); }
  bool empty() const { return azimuths_.empty(); }
  double scale(std::size_t row) const { return scales_[row]; }

  /// |row| of the values, and its standard error from theirs.
  PlacedValue of(std::size_t row, const std::vector<RingValue>& values) const;

  /// The row with the largest scaled |value|.
  std::size_t largest(const std::vector<RingValue>& values) const;

  /// |row| of that one, as of() gives it; nothing without rows.
  PlacedValue largestOf(const std::vector<RingValue>& values) const {
    return empty() ? PlacedValue{} : of(largest(values), values);
  }

  /// The largest scaled |value| of plain numbers, one per value of the ring.
  double largest(const double* values) const;

 private:
  struct Term {
    std::size_t value;
    double weight;
  };
  double sum(std::size_t row, const double* values) const;

  std::vector<double> azimuths_, scales_;
  std::vector<Term> terms_;
  std::vector<std::size_t> ends_;  ///< of each row among the terms
};

}  // namespace tank_datum
