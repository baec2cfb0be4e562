#pragma once

#include <vector>

#include "tank_datum/limits/checks.h"
#include "tank_datum/shell/shell_survey.h"

namespace tank_datum {

/// The shell's figures as they go to the limits: radii at the foot and above, plumbness.
/// @param facts  whose height says whether the scan holds the whole of it
std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts);

}  // namespace tank_datum
