#include "report/setups_json.h"

#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "report/json_number.h"
#include "report/station_arcs.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

const char* sourceOf(bool estimated, double given) {
  return given > 0.0 ? "given" : estimated ? "overlaps" : "assumed";
}

/// From and to of every run of stations that it sees, as azimuths.
Json seenArcs(const Setup& setup, const Datum& datum) {
  std::vector<char> seen(datum.stations.size(), 0);
  for (const std::size_t i : setup.seen) seen[i] = 1;
  return arcsJson(seen, datum.stations);
}

Json setupJson(const Setup& setup, const Datum& datum) {
  const bool moved = datum.agreement.adjusted();
  const Eigen::Vector3d origin = setup.origin + datum.origin;
  const auto sigma = [&](double value) { return moved ? number(value) : Json(nullptr); };
  return {{"name", setup.name},
          {"origin", setup.origin_known ? Json{origin.x(), origin.y(), origin.z()} : Json(nullptr)},
          {"turned_about", {origin.x(), origin.y(), origin.z()}},
          {"points", setup.points},
          {"stations", setup.stations},
          {"sees_deg", seenArcs(setup, datum)},
          {"dz", setup.correction.dz},
          {"sigma_dz", sigma(setup.sigma.dz)},
          {"tilt_x", setup.correction.tilt_x},
          {"sigma_tilt_x", sigma(setup.sigma.tilt_x)},
          {"tilt_y", setup.correction.tilt_y},
          {"sigma_tilt_y", sigma(setup.sigma.tilt_y)},
          {"dx", setup.correction.dx},
          {"sigma_dx", sigma(setup.sigma.dx)},
          {"dy", setup.correction.dy},
          {"sigma_dy", sigma(setup.sigma.dy)},
          {"rms_before", number(setup.rms_before)},
          {"rms_after", number(setup.rms_after)},
          {"verdict", nameOf(setup.verdict)}};
}

}  // namespace

Json setupsSection(const Datum& datum) {
  if (datum.levelled) return nullptr;
  Json list = Json::array();
  for (const Setup& setup : datum.agreement.setups) list.push_back(setupJson(setup, datum));
  return list;
}

Json covarianceSection(const Datum& datum) {
  if (datum.covariance.empty()) return nullptr;
  Json independent = Json::array(), factors = Json::array();
  const StationCovariance& covariance = datum.covariance;
  for (Eigen::Index i = 0; i < covariance.independent.size(); ++i)
    independent.push_back(number(covariance.independent[i]));
  for (Eigen::Index row = 0; row < covariance.factors.rows(); ++row) {
    Json values = Json::array();
    for (Eigen::Index i = 0; i < covariance.factors.cols(); ++i) {
      values.push_back(std::isfinite(covariance.independent[i]) ? Json(covariance.factors(row, i)) : Json(nullptr));
    }
    factors.push_back(values);
  }
  return {{"independent", independent}, {"factors", factors}};
}

Json agreementSection(const Datum& datum) {
  const SetupAgreement& agreement = datum.agreement;
  if (datum.levelled || agreement.setups.empty()) return nullptr;
  Json json = {{"rms_before", number(agreement.rms_before)},
               {"rms_after", number(agreement.rms_after)},
               {"repeated_points", agreement.repeated_points},
               {"unlabelled_discrepancy", number(agreement.unlabelled_discrepancy)}};
  if (agreement.merged_sigma > 0.0) {
    json["sigma_height"] = agreement.merged_sigma;
    json["height_from"] = agreement.unlabelled_discrepancy > 0.0 ? "overlaps" : sourceOf(false, agreement.given.height);
  }
  if (!agreement.adjusted()) return json;
  json["groups_apart"] = agreement.groups_apart;
  json["told_apart_by"] = agreement.by_order ? "order" : "labels";
  json["sigma_height"] = agreement.spread.height;
  json["sigma_tilt_arcsec"] = toArcSeconds(agreement.spread.tilt);
  json["sigma_plan"] = agreement.spread.plan;
  json["height_from"] = sourceOf(agreement.height_estimated, agreement.given.height);
  json["tilt_from"] = sourceOf(agreement.tilt_estimated, agreement.given.tilt);
  json["plan_from"] = sourceOf(agreement.plan_estimated, agreement.given.plan);
  return json;
}

std::string nodesCsv(const Datum& datum) {
  const StationCovariance& covariance = datum.covariance;
  std::string csv = "station,x,y,z,settlement,sigma_own";
  for (Eigen::Index k = 0; k < covariance.factors.rows(); ++k) csv += ",shared_" + std::to_string(k + 1);
  csv += "\n";
  const auto cell = [](double value) { return "," + shortestText(value); };
  for (std::size_t i = 0; i < datum.stations.size(); ++i) {
    const Station& s = datum.stations[i];
    const auto column = static_cast<Eigen::Index>(i);
    if (!std::isfinite(s.z) || covariance.empty()) continue;
    csv += std::to_string(i) + cell(s.x + datum.origin.x()) + cell(s.y + datum.origin.y()) +
           cell(s.z + datum.origin.z()) + cell(s.z - datum.level.mean) + cell(covariance.independent[column]);
    for (Eigen::Index k = 0; k < covariance.factors.rows(); ++k) csv += cell(covariance.factors(k, column));
    csv += "\n";
  }
  return csv;
}

}  // namespace tank_datum
