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

}  // namespace tank_datum
