#pragma once

#include <string>
#include <vector>

#include "movement/epoch.h"
#include "results/result_folder.h"
#include "tank_datum/movement/movement.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// Surveys of one tank in time order, each compared with the first.
struct Comparison {
  std::vector<std::string> names;   ///< of the surveys, the baseline first
  std::vector<std::string> hashes;  ///< SHA-256 of each one's datum.json
  std::vector<std::string> dates;   ///< as typed, one per survey; or none
  std::vector<Movement> movements;  ///< one fewer
  std::vector<StationHistory> histories;
  LimitRates limit_rates;
  MovementOptions options;
  Identity readers = {};  ///< units and language of what people read, and what they are told of the tank
};

/// Adds what the surveys show together: the stations' trends, and when limits are reached; by its dates, where it has
/// them. All movements then have the azimuths of the last survey.
/// @throws Error (Option) where the surveys' own dates are not in order
void followOverTime(Comparison& comparison, std::vector<Epoch> surveys);

/// What a trend is in: "m/year" with dates, "m/survey" without.
const char* trendUnit(const Comparison& comparison);

/// The median level of detection of the compared stations [m].
double medianLod(const Movement& movement);

/// movement.csv: one row per station of the last survey: azimuth_deg, trend (least-squares slope of the elevation,
/// metres per year with dates, else per survey), its standard error, then dz, lod95 and significant of each survey.
std::string movementCsv(const std::vector<StationHistory>& histories);

/// movement.json: the comparison of each survey with the first, whole, and the trend of each station.
std::string movementsJson(const Comparison& comparison);

/// Writes movement.json, movement.csv and report.html into a folder that commits them together.
/// @throws Error (File)
void writeMovement(const ResultFolder& folder, const Comparison& comparison);

}  // namespace tank_datum
