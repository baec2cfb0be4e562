#pragma once

namespace tank_datum {

/// The least value from 0 on at which an excess that falls with it is gone, to a part of 2^halvings of `most`; 0 where
/// there is none at 0, `most` where there is one up to it.
/// @param excess  excess(double) of a value
template <typename Excess>
double leastWithout(const Excess& excess, double most, int halvings) {
  double low = 0.0, high = most;
  if (excess(low) <= 0.0) return 0.0;
  for (int halving = 0; halving < halvings; ++halving) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace tank_datum
