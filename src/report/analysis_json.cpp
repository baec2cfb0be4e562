#include "report/analysis_json.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "report/json_number.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

Json textOrNull(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json harmonicsJson(const std::vector<Harmonic>& harmonics, double z_origin) {
  Json all = Json::array();
  for (const Harmonic& h : harmonics) {
    all.push_back({{"n", h.n},
                   {"amplitude", number(h.amplitude + (h.n == 0 ? z_origin : 0.0))},
                   {"phase_deg", number(toDegrees(h.crest))},
                   {"sigma", number(h.sigma)}});
  }
  return all;
}

Json placed(const PlacedValue& v) {
  return {{"value", number(v.value)}, {"sigma", number(v.sigma)}, {"azimuth_deg", number(toDegrees(v.azimuth))}};
}

Json interval(const Interval95& i) { return {number(i.low), number(i.high)}; }

Json secondDifferencesJson(const SecondDifferences& d) {
  const PlacedValue worst = d.valid() ? d.all[d.worst] : PlacedValue{};
  return {{"points", d.points},     {"starts", d.starts},     {"spacing", number(d.spacing)},
          {"worst", placed(worst)}, {"values", d.all.size()}, {"message", d.message}};
}

Json arcsJson(const std::vector<SettlementArc>& arcs) {
  Json all = Json::array();
  for (const SettlementArc& arc : arcs) {
    Json entry = placed(arc.largest);
    entry["length"] = number(arc.length);
    all.push_back(entry);
  }
  return all;
}

/// The limit of the curvature that is judged by, when it could be had.
Json curvatureLimit(const std::vector<Check>& checks) {
  const auto found = std::find_if(checks.begin(), checks.end(),
                                  [](const Check& c) { return c.unit == "1/m" && std::isfinite(c.limit); });
  return found == checks.end() ? Json(nullptr) : Json(found->limit);
}

Json ovalityJson(const Ovality& ovality) {
  if (!std::isfinite(ovality.largest.value)) return nullptr;
  Json json = placed(ovality.largest);
  json["low95"] = number(ovality.interval.low), json["high95"] = number(ovality.interval.high);
  return json;
}

Json outOfPlaneJson(const Analysis& analysis, const std::vector<Station>& stations) {
  const OutOfPlane& fit = analysis.out_of_plane;
  Json u_fit = Json::array(), curvature = Json::array();
  for (const Station& s : stations) {
    u_fit.push_back(number(s.sigma_u_fit));
    curvature.push_back(number(s.sigma_curvature));
  }
  return {{"order", fit.order},
          {"message", fit.message},
          {"adjusted_r2", number(fit.adjusted_r2)},
          {"rms", number(fit.rms)},
          {"max_abs_u", number(fit.max_u)},
          {"max_abs_u_azimuth_deg", number(toDegrees(fit.max_u_azimuth))},
          {"max_curvature", number(fit.max_curvature)},
          {"max_curvature_azimuth_deg", number(toDegrees(fit.max_curvature_azimuth))},
          {"sigma_curvature", number(fit.sigma_curvature)},
          {"max_curvature_95", interval(fit.curvature_interval)},
          {"max_abs_u_95", interval(fit.u_interval)},
          {"curvature_limit", curvatureLimit(analysis.checks)},
          {"top_ovality", ovalityJson(analysis.top_ovality)},
          {"longest_gap", number(analysis.longest_gap)},
          {"u_fit_sigma", u_fit},
          {"curvature_sigma", curvature},
          {"second_differences", secondDifferencesJson(analysis.second_differences)},
          {"arcs", arcsJson(analysis.arcs)}};
}

Json checksJson(const std::vector<Check>& checks) {
  Json all = Json::array();
  for (const Check& c : checks) {
    all.push_back({{"code", c.code},
                   {"clause", c.clause},
                   {"name", c.name},
                   {"value", number(c.value)},
                   {"sigma", number(c.sigma)},
                   {"low95", number(c.interval.low)},
                   {"high95", number(c.interval.high)},
                   {"limit", number(c.limit)},
                   {"unit", c.unit},
                   {"azimuth_deg", number(toDegrees(c.azimuth))},
                   {"verdict", nameOf(c.verdict)},
                   {"role", c.role},
                   {"source", c.trust},
                   {"citation", c.citation},
                   {"note", c.note}});
  }
  return all;
}

Json localSettlementsJson(const std::vector<LocalSettlement>& settlements) {
  Json all = Json::array();
  for (const LocalSettlement& s : settlements) {
    all.push_back({{"azimuth_deg", number(toDegrees(s.azimuth))},
                   {"width_deg", number(toDegrees(s.width))},
                   {"height", number(s.height)},
                   {"sigma", number(s.sigma)}});
  }
  return all;
}

}  // namespace

void addAnalysis(Json& json, const Analysis& analysis, const std::vector<Station>& stations, double z_origin) {
  json["harmonics"] = harmonicsJson(analysis.harmonics, z_origin);
  json["out_of_plane"] = outOfPlaneJson(analysis, stations);
  json["local_settlements"] = localSettlementsJson(analysis.local_settlements);
  json["foundation"] = {{"level_9m", placed(analysis.level_9m)},
                        {"level_3m", placed(analysis.level_3m)},
                        {"level_total", placed(analysis.level_total)}};
  json["checks"] = checksJson(analysis.checks);
  json["verdict"] = {{"word", analysis.headline.word},
                     {"governing", textOrNull(analysis.headline.governing)},
                     {"utilisation", number(analysis.headline.utilisation)},
                     {"utilisation_95", interval(analysis.headline.utilisation_interval)},
                     {"sentence", analysis.headline.sentence}};
  json["notes"] = analysis.notes;
}

}  // namespace tank_datum
