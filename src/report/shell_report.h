#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/display.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/shell/shell_survey.h"

namespace tank_datum {

/// The section "shell" of datum.json. Metres, degrees; unknown values null.
/// @param tolerances  of the survey's roundness, height by height
nlohmann::ordered_json shellJson(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances);

/// shell.csv: the header line, then a row per height and azimuth where the shell is seen; unknown values are empty.
std::string shellCsv(const ShellSurvey& survey);

/// The summary's lines on the shell: roundness, plumbness, or why there is neither.
std::string shellSummary(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances,
                         const Display& display = Display());

}  // namespace tank_datum
