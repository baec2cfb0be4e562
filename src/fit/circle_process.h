#pragma once

#include <vector>

namespace tank_datum {

/// A value and its standard errors.
struct NoisyValue {
  double value;  ///< NaN where unknown
  double sigma;  ///< what it errs by alone, as far as is known
  double alike;  ///< what it errs by besides as its neighbours do, within a radian
};

/// What a process is at a place, and the standard error of that.
struct ProcessValue {
  double value = 0, sigma = 0;
};

/// What values at equal steps round a circle follow, at every step: a Gaussian process of mean zero (Matern of order
/// 3/2 over the chord; Rasmussen and Williams 2006, 4.2). Its amplitude and length, or that there is none, and what the
/// values err by beside their standard errors, are each as likely as the values are under them, so that what the values
/// leave open of the process is in the errors.
/// @param common  what each value may err by besides, at most: all of it, half or nothing
/// @param usual   amplitude that the process has at most, usually: one of twice as much is a quarter as likely, of four
///                times as much a sixteenth; the errors where no value is known
std::vector<ProcessValue> followCircle(const std::vector<NoisyValue>& series, double common, double usual);

}  // namespace tank_datum
