#pragma once

#include <cstddef>
#include <vector>

#include "fit/ring_process.h"

namespace tank_datum {

/// What a Matern process of order 3/2 is like, and what values scatter by about it.
struct ProcessParameters {
  double amplitude, length;
  double scale, nugget;  // the values scatter by the hypotenuse of scale times their standard errors and of the nugget

  double variance(double given) const { return scale * scale * given + nugget * nugget; }
};

/// Values at equal steps round a ring, NaN where unknown, with the variances of their errors.
struct RingData {
  std::vector<double> values, variances;
  double step;  ///< [rad]
};

/// How unlikely the values are under the process, by Student's distribution with thirty degrees of freedom: no single
/// stray value decides.
double unlikeliness(const RingData& data, const ProcessParameters& p);

/// What the values say of the process at every place, by Kalman filter and smoother: `value` and `sigma` of the result.
void smoothRing(const RingData& data, const ProcessParameters& p, RingProcess& result);

/// How far each value lies off what the others say, and the standard deviation of that; 0 and 1 where there is none.
struct OffOthers {
  std::vector<double> distance, sigma;
};

/// @param smoothed  what all values say
OffOthers offOthers(const RingData& data, const ProcessParameters& p, const RingProcess& smoothed);

/// Variance at every place of harmonics that the values were freed of beforehand, as far as the process does not make
/// up for them: none beside values, all of it in gaps longer than the process is alike (universal kriging: Rasmussen
/// and Williams 2006, 2.7).
/// @param order  highest of the harmonics
std::vector<double> varianceOfShape(const RingData& data, const ProcessParameters& p, int order);

}  // namespace tank_datum
