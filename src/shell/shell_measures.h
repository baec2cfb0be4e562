#pragma once

#include <vector>

#include "tank_datum/limits/limits.h"
#include "tank_datum/shell/shell_survey.h"

namespace tank_datum {

/// The shell's figures as they go to the limits: radii at the foot and above, plumbness.
/// @param facts  whose height says whether the scan holds the whole of it
std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts);

/// The radii at each height of the survey beside their tolerance, by the same limits and the same rule as the checks.
/// @param diameter  of the tank [m]
std::vector<LimitComparison> compareRoundness(const ShellSurvey& survey, const std::vector<Limit>& limits,
                                              const TankFacts& facts, double diameter);

}  // namespace tank_datum
