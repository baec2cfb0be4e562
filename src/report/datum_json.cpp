#include <cmath>
#include <nlohmann/json.hpp>

#include "core/portable_math.h"
#include "core/units.h"
#include "io/json_file.h"
#include "options/option_json.h"
#include "refusals.h"
#include "report/analysis_json.h"
#include "report/datum_record.h"
#include "report/identity.h"
#include "report/json_number.h"
#include "report/movement_json.h"
#include "report/setups_json.h"
#include "report/shell_report.h"
#include "report/station_arcs.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/report/report.h"
#include "tank_datum/stations/stations.h"
#include "tank_datum/trust/tank_tests.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

Json optionsUsed(const Provenance& provenance) {
  RunOptions run;
  run.datum = provenance.options;
  run.movement = provenance.movement_options;
  run.up = provenance.up;
  run.reading = provenance.reading;
  run.baseline = provenance.baseline;
  return optionsJson(run);
}

Json fileJson(const InputRecord& file) {
  const bool is_sha256 = file.checksum == Checksum::Sha256;
  Json hash;
  if (!file.hash.empty()) hash = {{"algorithm", is_sha256 ? "sha256" : "xxh3_128"}, {"value", file.hash}};
  return {{"path", file.path},
          {"sha256", is_sha256 && !file.hash.empty() ? Json(file.hash) : Json()},
          {"hash", hash},
          {"points", file.points}};
}

Json inputJson(const Provenance& provenance, const Eigen::Vector3d& origin, bool levelled) {
  Json files = Json::array();
  for (const InputRecord& file : provenance.files) files.push_back(fileJson(file));
  return {{"files", files},
          {"kind", levelled ? "levelling" : "scan"},
          {"units", provenance.units},
          {"origin", {origin.x(), origin.y(), origin.z()}},
          {"invalid_points", provenance.invalid_points},
          {"left_out_points", provenance.left_out_points},
          {"far_points", provenance.far_points}};
}

Json tankJson(const Datum& datum) {
  if (!datum.tank.circle.valid()) return nullptr;
  const Circle& circle = datum.circle.valid() ? datum.circle : datum.tank.circle;
  return {{"center", {circle.center.x() + datum.origin.x(), circle.center.y() + datum.origin.y()}},
          {"radius", circle.radius},
          {"sigma_radius", number(datum.refined.sigma_radius)},
          {"rms", number(datum.levelled ? kUnknown : datum.tank.rms)},
          {"coverage_deg", datum.levelled ? Json(nullptr) : Json(toDegrees(datum.tank.coverage))},
          {"foot_points_per_degree", number(datum.foot_density)},
          {"side", datum.levelled ? Json(nullptr) : Json(datum.tank.side == Side::Inside ? "inside" : "outside")}};
}

Json datumSection(const Datum& datum) {
  const Level& level = datum.level;
  const double z = datum.origin.z();
  const bool refined = datum.refined.valid();
  return {{"surface", refined ? Json(nameOf(datum.refined.profile.surface)) : Json(nullptr)},
          {"other_surface_deg", arcsJson(withReason(datum.stations, Unmeasured::OtherSurface), datum.stations)},
          {"shell_below_deg", arcsJson(withReason(datum.stations, Unmeasured::ShellBelow), datum.stations)},
          {"in_doubt_deg", arcsJson(inDoubt(datum.stations), datum.stations)},
          {"measured", level.measured},
          {"interpolated", level.interpolated},
          {"missing", level.missing},
          {"mean", number(level.mean + z)},
          {"min", number(level.min + z)},
          {"max", number(level.max + z)},
          {"range", number(level.range())},
          {"min_azimuth_deg", number(toDegrees(level.min_azimuth))},
          {"max_azimuth_deg", number(toDegrees(level.max_azimuth))},
          {"curve",
           {{"degree", 3},
            {"closed", true},
            {"control_points", datum.curve.control_points.rows()},
            {"rms", number(datum.curve.rms)},
            {"max_residual", number(datum.curve.max_residual)},
            {"check_points", datum.curve.check_points}}}};
}

Json tiltJson(const Tilt& tilt) {
  if (!tilt.valid()) return nullptr;
  return {{"slope", tilt.slope()},
          {"angle_arcsec", toArcSeconds(portable::atan(tilt.slope()))},
          {"direction_deg", toDegrees(tilt.direction)},
          {"sigma_slope", number(tilt.sigma_slope)},
          {"standard_error", number(tilt.standard_error)},
          {"r2", number(tilt.r2)},
          {"p_value", number(tilt.p_value)}};
}

/// The paper's inclination, and its table: h of every diameter.
Json antipodalJson(const Datum& datum) {
  const Antipodal& antipodal = datum.antipodal;
  Json heights = Json::array();
  for (const double h : antipodalHeights(datum.stations)) heights.push_back(number(h));
  return {{"max_h", number(antipodal.max_h)},
          {"diameter", number(antipodal.diameter)},
          {"angle_deg", number(toDegrees(antipodal.angle()))},
          {"angle_arcsec", number(toArcSeconds(antipodal.angle()))},
          {"azimuth_deg", number(toDegrees(antipodal.azimuth))},
          {"h", heights}};
}

/// What was asked of the thing found, to know whether it is a tank.
Json testsJson(const std::vector<TankTest>& tests) {
  Json json = Json::array();
  for (const TankTest& t : tests) {
    json.push_back({{"name", t.name},
                    {"value", number(t.value)},
                    {"limit", number(t.limit)},
                    {"unit", t.unit},
                    {"outcome", nameOf(t.outcome)},
                    {"finding", t.outcome == TestOutcome::Pass ? Json(nullptr) : Json(t.finding)}});
  }
  return json;
}

Json leanJson(const Datum& datum, const StationOptions& options) {
  if (!datum.lean.known()) return nullptr;
  const std::string text = leanText(datum, options);
  return {{"slope_x", datum.lean.slope.x()},
          {"slope_y", datum.lean.slope.y()},
          {"sigma", datum.lean.sigma},
          {"sentence", text.empty() ? Json(nullptr) : Json(text)}};
}

Json pointJson(const SurveyPoint& point, double z) {
  return {{"number", point.number},
          {"azimuth_deg", toDegrees(point.azimuth)},
          {"z", number(point.z + z)},
          {"sigma_z", number(point.sigma_z)},
          {"u", number(point.u)}};
}

/// What the user says of the tank, and the survey's points.
void addIdentity(Json& json, const Datum& datum, const Provenance& provenance) {
  const Identity& identity = provenance.identity;
  const StationOptions& stations = provenance.options.stations;
  addTold(json, identity);
  if (std::isfinite(identity.north)) json["north_azimuth_deg"] = toDegrees(azimuthOf(identity.north, stations));
  for (const SurveyPoint& point : surveyPointsOf(identity, datum.stations, stations)) {
    json["survey_points"].push_back(pointJson(point, datum.origin.z()));
  }
}

}  // namespace

void addTold(Json& json, const Identity& identity) {
  for (const auto& [key, words] : identity.about) json["about"][key] = words;
  for (const ReferenceMark& mark : identity.marks) {
    json["marks"].push_back({{"name", mark.name}, {"azimuth_deg", toDegrees(mark.azimuth)}});
  }
  if (identity.display_units != "mm") json["display_units"] = identity.display_units;
  if (identity.language != "en") json["language"] = identity.language;
}

Json datumRecord(const Datum& datum, const Provenance& provenance) {
  Json json;
  json["schema"] = kSchema;
  json["version"] = kVersion;
  json["input"] = inputJson(provenance, datum.origin, datum.levelled);
  json["options"] = optionsUsed(provenance);
  json["status"] = nameOf(datum.status);
  json["message"] = datum.message;
  if (!datum.sighting.advice.empty()) json["advice"] = datum.sighting.advice;
  addIdentity(json, datum, provenance);
  json["service"] = nameOf(provenance.options.analysis.facts.service);
  json["tank"] = tankJson(datum);
  json["tests"] = testsJson(datum.tests);
  json["lean"] = leanJson(datum, provenance.options.stations);
  if (datum.hasStations()) {
    json["datum"] = datumSection(datum);
    json["tilt"] = tiltJson(datum.tilt);
    json["antipodal"] = antipodalJson(datum);
    if (datum.analysis.valid()) addAnalysis(json, datum.analysis, datum.stations, datum.origin.z());
    json["setups"] = setupsSection(datum);
    json["agreement"] = agreementSection(datum);
    json["covariance"] = covarianceSection(datum);
    json["stations"] = stationsSection(datum);
    if (provenance.movement) {
      json["movement"] = movementSection(*provenance.movement);
      json["movement"]["limits"] = limitRatesSection(provenance.limit_rates);
    }
    if (datum.shell.valid()) json["shell"] = shellJson(datum.shell, datum.analysis.roundness);
  }
  return json;
}

std::string datumJson(const Datum& datum, const Provenance& provenance) {
  // a path that is no UTF-8 must not lose the result
  return datumRecord(datum, provenance).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tank_datum
