#include <cmath>
#include <nlohmann/json.hpp>

#include "core/units.h"
#include "report/json_number.h"
#include "report/shell_report.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

Json roundnessJson(const Roundness& r, const LimitComparison& tolerance) {
  return {{"height", r.height},
          {"radius", r.circle.radius},
          {"max_deviation", r.max_deviation},
          {"min_deviation", r.min_deviation},
          {"azimuth_deg", toDegrees(r.azimuth)},
          {"sigma", number(r.sigma)},
          {"n", r.stations},
          {"widest_gap", r.widest_gap},
          {"tolerance", number(tolerance.limit)},
          {"verdict", nameOf(tolerance.verdict)}};
}

Json plumbnessJson(const Plumbness& p) {
  return {{"azimuth_deg", toDegrees(p.azimuth)},
          {"height", p.height},
          {"offset", p.offset},
          {"sigma", number(p.sigma)},
          {"slope", p.slope},
          {"sigma_slope", number(p.sigma_slope)}};
}

Json leanJson(const Lean& lean) {
  if (!lean.valid()) return nullptr;
  return {{"slope", lean.slope()},
          {"sigma_slope", lean.sigma},
          {"direction_deg", toDegrees(lean.direction)},
          {"height", lean.height},
          {"offset", lean.offset()}};
}

}  // namespace

Json shellJson(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances) {
  Json roundness = Json::array(), plumbness = Json::array();
  for (std::size_t i = 0; i < survey.roundness.size(); ++i) {
    roundness.push_back(roundnessJson(survey.roundness[i], i < tolerances.size() ? tolerances[i] : LimitComparison()));
  }
  for (const Plumbness& p : survey.plumbness) plumbness.push_back(plumbnessJson(p));
  const Plumbness* worst = survey.worstPlumbness();
  const Plumbness unknown;
  if (!worst) worst = &unknown;
  return {{"roundness", roundness},
          {"plumbness", plumbness},
          {"plumbness_max", number(std::abs(worst->offset))},
          {"plumbness_sigma", number(worst->sigma)},
          {"plumbness_height", number(worst->height)},
          {"plumbness_azimuth_deg", number(toDegrees(worst->azimuth))},
          {"lean", leanJson(survey.lean)}};
}

}  // namespace tank_datum
