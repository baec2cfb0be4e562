#pragma once

#include <vector>

namespace tank_datum {

// Values at equal steps round the tank; NaN where unknown.

/// Unknown values taken from the nearest known ones on either side, in proportion; unchanged when none is known.
std::vector<double> filledUp(const std::vector<double>& values);

/// The median of the known values within `reach` steps.
std::vector<double> runningMedian(const std::vector<double>& values, int reach);

}  // namespace tank_datum
