#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/run_options.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// What a file of `about` may hold, in the order of the report: "tank", "product", ... without "logo".
const std::vector<std::string>& aboutKeys();

/// Reads and checks what the options about, mark, north_deg and survey_points say into run.identity.
/// @throws Error (File) for a file that cannot be read or has other keys, a logo that is no image or larger than 1 MB;
///         (Option) for a mark that is not NAME=DEG
void readIdentity(RunOptions& run);

/// Of several tanks of one scan, which share what was said of it, each has its own name: "T-12, tank_2".
void nameTank(Identity& identity, std::size_t number, std::size_t tanks);

/// The datum at a point of the survey between stations.
struct SurveyPoint {
  int number = 0;             ///< from 1
  double azimuth = kUnknown;  ///< as stations are counted [rad]
  double z = kUnknown;        ///< between the stations beside it, relative to the scan's origin [m]
  double sigma_z = kUnknown;  ///< the larger of theirs [m]
  double u = kUnknown;        ///< out-of-plane settlement [m]
};

/// The points asked for; unknown where a station beside one is missing or far away, as RingSeries has it.
std::vector<SurveyPoint> surveyPointsOf(const Identity& identity, const std::vector<Station>& stations,
                                        const StationOptions& options);

}  // namespace tank_datum
