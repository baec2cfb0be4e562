#pragma once

#include <vector>

namespace tank_datum {

/// Two groups of setups whose heights agree within each, and not from one to the other.
struct SetupGroups {
  double apart = 0.0;               ///< their mean heights [m]; 0: there are no two groups
  std::vector<bool> higher, lower;  ///< of every setup, whether it is of that group

  bool found() const { return apart > 0.0; }
  /// The group of fewer setups.
  const std::vector<bool>& smaller() const;
};

/// Looks for two groups of two setups or more, as two surveys in one scan make, or two registrations of one: farther
/// apart than setups that err independently are by chance once in 300 times, however they are parted.
/// @param heights  errors of the setups' heights [m]; NaN of one that cannot be compared
SetupGroups twoGroups(const std::vector<double>& heights);

}  // namespace tank_datum
