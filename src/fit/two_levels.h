#pragma once

#include <vector>

namespace tank_datum {

/// Values that are normal about two levels with one standard deviation.
struct TwoLevels {
  double share = 0.0;  ///< of the values that belong to the lower level
  double low = 0.0, high = 0.0;
  double sigma = 0.0;  ///< about their level
  double gain = 0.0;   ///< of the logarithm of the likelihood against one level with a deviation of its own

  double apart() const { return high - low; }
  /// Whether a value is rather of the upper level.
  bool isHigh(double value) const;
};

/// The likeliest two levels, by the EM algorithm (Dempster, Laird and Rubin 1977) from three starts.
/// @param values  at least 3, not all alike
TwoLevels fitTwoLevels(const std::vector<double>& values);

/// Gain of the logarithm of the likelihood, against one level with a deviation of its own, where some values are of one
/// level and the others lie anywhere between the least and the largest: plants on a surface are no second level.
/// @param values  at least 3, not all alike
double gainOfStrays(const std::vector<double>& values);

}  // namespace tank_datum
