#pragma once

#include <vector>

#include "shell/shell_bands.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/setups/setups.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// Roundness and plumbness from the points of a scan's shell; heights count from the stations' elevations.
/// @param circle  of the datum, about whose centre the stations stand [m]
ShellSurvey surveyShell(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                        const ShellOptions& options, const StationOptions& station_options);

/// The same of a scan whose setups stand, and are tilted, by that much beside their places: the shell is surveyed as
/// the scan has it, and lobes and lean are what they make of it.
/// @param setups  that see it, side by side: tilts of narrow parts of a ring turn its axis by twice their mean
ShellSurvey withSetupErrors(ShellSurvey survey, const SetupSpread& error, std::size_t setups);

}  // namespace tank_datum
