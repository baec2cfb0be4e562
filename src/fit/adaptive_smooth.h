#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// A value at equal steps round the tank, unknown where not finite.
struct SeriesValue {
  double value;
  double sigma;   ///< standard error
  double shared;  ///< steps that it was averaged over already, 1 or more
};

/// Smooths a series by parabolas, each over the widest window whose result agrees with those of all narrower ones
/// (intersection of confidence intervals: Goldenshluger and Nemirovski 1997): wide where the series is smooth, a single
/// step where it is not. Unknown values stay so.
/// @param widest  steps on either side
std::vector<SeriesValue> smoothed(const std::vector<SeriesValue>& series, std::size_t widest);

/// A place between two values of a series; at the one where the other is unknown.
class BetweenValues {
 public:
  /// @param place  counted from the first value, `stride` to a step
  BetweenValues(const std::vector<SeriesValue>& series, std::size_t place, std::size_t stride);

  bool known() const;
  /// Of the values, or of their standard errors, of a series that is known at the same steps.
  double mean(const std::vector<SeriesValue>& series, double SeriesValue::*what) const;

 private:
  std::size_t left_, right_;
  double share_;  // of the right one
  bool known_;
};

}  // namespace tank_datum
