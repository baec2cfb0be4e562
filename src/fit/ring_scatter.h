#pragma once

#include <vector>

namespace tank_datum {

/// How far values round a ring scatter beside what they follow, in their standard errors: from their third differences,
/// which a parabola leaves at zero, by a quantile, so that a dip or a stray value says little. What neighbours share
/// makes neighbouring differences smaller than those of values farther apart, and counts by as much as it is lost from
/// means over many values.
/// @param values  at equal steps, NaN where unknown
/// @param sigmas  their standard errors
/// @return 0 where too few values lie close enough together to tell
double ringScatter(const std::vector<double>& values, const std::vector<double>& sigmas);

}  // namespace tank_datum
