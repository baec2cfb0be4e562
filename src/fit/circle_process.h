#pragma once

#include <vector>

namespace tank_datum {

/// A value and its standard errors.
struct NoisyValue {
  double value;  ///< NaN where unknown
  double sigma;  ///< what it errs by alone
  double alike;  ///< what it errs by besides as its neighbours do, within a radian
};

/// What a process is at a place, and the standard error of that.
struct ProcessValue {
  double value = 0, sigma = 0;
};

/// What values at equal steps round a circle follow, at every step: a Gaussian process of mean zero (Matern of order
/// 3/2 over the chord; Rasmussen and Williams 2006, 4.2). Its amplitude and length, or that there is none, are each as
/// likely as the values are under them, so that what the values leave open of the process is in the errors.
/// @param largest  amplitude that the process may have, and the errors where no value is known
std::vector<ProcessValue> followCircle(const std::vector<NoisyValue>& series, double largest);

}  // namespace tank_datum
