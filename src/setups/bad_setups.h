#pragma once

#include <vector>

#include "setups/overlaps.h"
#include "setups/setup_system.h"

namespace tank_datum {

/// How far off a setup is by chance once in 300 times, by the sigmas of the others.
struct BadSetupBounds {
  double usual_worth;  ///< setups' worth of the usual sigmas that the others' are drawn by
  bool estimates;      ///< whether the others' sigmas count as estimates from so many setups, else as known

  /// The bound of a sum of squares.
  double of(double parameters, double others) const;
};

/// A bad setup is named as a good surveyor's would be. Its priors are lifted only where few others leave no doubt: of
/// setups that are all badly registered one is far off by chance, and the sigmas of the others are too small then.
constexpr BadSetupBounds kNamed{6.0, false}, kFreed{3.0, true};

/// Of so many setups as many may be bad: one of three to nine, one in five of more.
std::size_t mostBad(std::size_t setups);

/// The bad setups, whose error, as the overlaps alone tell it, is beyond the bound under the sigmas of the others: one
/// of three to nine, one in five of more. Where one more is nearly as far off as the last of them none is an exception,
/// and the sigma of all is large. What says that a setup is bad is seen in more than one place: one alone may show
/// something else than the tank.
std::vector<bool> badSetups(const Overlaps& overlaps, const KindSigmas& usual, const BadSetupBounds& bounds);

}  // namespace tank_datum
