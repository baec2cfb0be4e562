#include "movement_files.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/plain_text.h"
#include "core/statistics.h"
#include "core/units.h"
#include "io/json_file.h"
#include "movement/movement.h"
#include "movement/trend.h"
#include "options/option_json.h"
#include "report/datum_record.h"
#include "report/json_number.h"
#include "report/movement_json.h"
#include "report/report_page.h"
#include "report/text_file.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

}  // namespace

void followOverTime(Comparison& comparison, std::vector<Epoch> surveys) {
  if (comparison.dates.empty()) requireInOrder(surveys);
  // refuses another number of dates
  comparison.histories = historiesOf(comparison.movements, timesOf(comparison.dates, surveys.size()));
  for (std::size_t i = 0; i < comparison.dates.size(); ++i) surveys[i].date = comparison.dates[i];
  const double offset = comparison.movements.back().azimuth_offset;
  for (Movement& m : comparison.movements) m = countedAs(surveys.back(), offset, std::move(m));
  comparison.limit_rates = limitRatesOf(surveys);
}

const char* trendUnit(const Comparison& comparison) { return comparison.dates.empty() ? "m/survey" : "m/year"; }

double medianLod(const Movement& movement) {
  std::vector<double> levels;
  for (const StationMovement& s : movement.stations) {
    if (std::isfinite(s.dz)) levels.push_back(s.lod95());
  }
  return median(std::move(levels));
}

std::string movementCsv(const std::vector<StationHistory>& histories) {
  const std::size_t surveys = histories.empty() ? 0 : histories.front().surveys.size();
  std::string csv = "azimuth_deg,trend,sigma_trend";
  for (std::size_t i = 1; i <= surveys; ++i) {
    const std::string n = std::to_string(i);
    csv += ",dz_" + n + ",lod95_" + n + ",significant_" + n;
  }
  csv += "\n";
  for (const StationHistory& place : histories) {
    csv +=
        shortestText(toDegrees(place.azimuth)) + "," + shortestText(place.rate) + "," + shortestText(place.sigma_rate);
    for (const StationMovement& s : place.surveys) {
      csv += "," + shortestText(s.dz) + "," + shortestText(s.lod95()) + "," +
             (std::isfinite(s.dz) ? s.significant ? "1" : "0" : "");
    }
    csv += "\n";
  }
  return csv;
}

namespace {

Json surveysSection(const Comparison& comparison) {
  Json surveys = Json::array();
  for (std::size_t i = 0; i < comparison.names.size(); ++i) {
    surveys.push_back({{"path", comparison.names[i]},
                       {"sha256", comparison.hashes[i]},
                       {"date", comparison.dates.empty() ? Json(nullptr) : Json(comparison.dates[i])}});
  }
  return surveys;
}

}  // namespace

std::string movementsJson(const Comparison& comparison) {
  Json surveys = Json::array(), stations = Json::array();
  for (std::size_t i = 0; i < comparison.movements.size(); ++i) {
    Json movement = movementSection(comparison.movements[i]);
    movement["survey"] = comparison.names[i + 1];
    movement["date"] = comparison.dates.empty() ? Json(nullptr) : Json(comparison.dates[i + 1]);
    surveys.push_back(movement);
  }
  for (const StationHistory& place : comparison.histories) {
    stations.push_back({{"azimuth_deg", toDegrees(place.azimuth)},
                        {"rate", number(place.rate)},
                        {"sigma", number(place.sigma_rate)},
                        {"lod95", number(place.lod95())},
                        {"significant", place.significant}});
  }
  Json json = {{"schema", kSchema},
               {"version", kVersion},
               {"surveys", surveysSection(comparison)},
               {"options", movementValues(comparison.options)},
               {"baseline", comparison.names.front()},
               {"baseline_date", comparison.dates.empty() ? Json(nullptr) : Json(comparison.dates.front())},
               {"movements", surveys},
               {"trend", {{"unit", trendUnit(comparison)}, {"stations", stations}}},
               {"limits", limitRatesSection(comparison.limit_rates)}};
  addTold(json, comparison.readers);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void writeMovement(const ResultFolder& folder, const Comparison& comparison) {
  const fs::path to(folder.stage(""));
  const std::string json = movementsJson(comparison);
  writeTextFile(to / "movement.json", json);
  const std::string csv = movementCsv(comparison.histories);
  writeTextFile(to / "movement.csv", csv);
  writeTextFile(to / "report.html", trendPage(json, csv, comparison.readers.logo));
}

}  // namespace tank_datum
