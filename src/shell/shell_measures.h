#pragma once

#include <vector>

#include "limits/limit_tables.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/shell/shell_survey.h"

namespace tank_datum {

/// The shell's figures as they go to the limits: radii at the foot and above, plumbness.
/// Plumbness is of the whole ring where nearly all of the height is seen, and no wider arc lies between than survey
/// points are apart.
/// @param facts   whose height is the shell's; without it the most that is seen is
/// @param radius  of the tank [m]
std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts, double radius);

/// The radii at each height of the survey beside their tolerance, by the same limits and the same rule as the checks.
/// @param diameter  of the tank [m]
std::vector<LimitComparison> compareRoundness(const ShellSurvey& survey, const std::vector<Limit>& limits,
                                              const TankFacts& facts, const Diameter& diameter);

}  // namespace tank_datum
