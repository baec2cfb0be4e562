#include "report/movement_json.h"

#include <cmath>

#include "core/portable_math.h"
#include "core/units.h"
#include "movement/limit_rates.h"
#include "report/json_number.h"
#include "report/movement_text.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

using Json = nlohmann::ordered_json;

Json stationsSection(const Datum& datum) {
  Json stations = Json::array();
  for (const Station& s : datum.stations) {
    stations.push_back({{"azimuth_deg", toDegrees(s.azimuth)},
                        {"direction_deg", toDegrees(s.direction)},
                        {"z", number(s.z + datum.origin.z())},
                        {"sigma_z", number(s.sigma_z)},
                        {"window_deg", number(toDegrees(s.window))},
                        {"flag", nameOf(s.flag)},
                        {"reason", s.reason == Unmeasured::None ? Json() : Json(nameOf(s.reason))}});
  }
  return stations;
}

Json movementSection(const Movement& movement) {
  Json stations = Json::array();
  for (const StationMovement& s : movement.stations) {
    stations.push_back({{"azimuth_deg", toDegrees(s.azimuth)},
                        {"dz", number(s.dz)},
                        {"rest", number(s.rest)},
                        {"lod95", number(s.lod95())},
                        {"significant", s.significant}});
  }
  return {{"baseline", movement.baseline},
          {"removed", nameOf(movement.removal)},
          {"registration_error", movement.registration_error},
          {"registration_tilt_arcsec", toArcSeconds(movement.registration_tilt)},
          {"azimuth_offset_deg", toDegrees(movement.azimuth_offset)},
          {"sigma_azimuth_offset_deg", toDegrees(movement.sigma_azimuth_offset)},
          {"centre_apart", number(movement.centre_apart)},
          {"message", movement.message},
          {"matched", movement.matched},
          {"significant", movement.significant},
          {"threshold", number(movement.threshold)},
          {"errors",
           {{"over_given", number(movement.errors_shown)},
            {"used", number(movement.errors_used)},
            {"shared_deg", toDegrees(movement.shared_arc)}}},
          {"mean",
           {{"value", number(movement.mean)},
            {"sigma", number(movement.sigma_mean)},
            {"significant", movement.mean_significant}}},
          {"tilt_change",
           {{"slope", number(movement.tilt_change)},
            {"sigma", number(movement.sigma_tilt_change)},
            {"angle_arcsec", number(toArcSeconds(portable::atan(movement.tilt_change)))},
            {"direction_deg", number(toDegrees(movement.tilt_direction))},
            {"azimuth_deg", number(toDegrees(movement.rise_azimuth))},
            {"p_value", number(movement.tilt_p_value)},
            {"significant", movement.tilt_significant}}},
          {"out_of_plane",
           {{"value", number(movement.max_rest)},
            {"sigma", number(movement.sigma_rest)},
            {"threshold", number(movement.rest_threshold)},
            {"azimuth_deg", number(toDegrees(movement.rest_azimuth))},
            {"significant", movement.rest_significant}}},
          {"moved", movement.moved()},
          {"not_given", unsaidOf(movement)},
          {"max", number(movement.max)},
          {"max_azimuth_deg", number(toDegrees(movement.max_azimuth))},
          {"rms", number(movement.rms)},
          {"stations", stations}};
}

Json limitRatesSection(const LimitRates& rates) {
  const auto month = [](double year) { return std::isfinite(year) ? Json(monthOf(year)) : Json(nullptr); };
  Json all = Json::array();
  for (const LimitRate& r : rates.rates) {
    all.push_back({{"code", r.check.code},
                   {"clause", r.check.clause},
                   {"name", r.check.name},
                   {"unit", r.check.unit},
                   {"value", number(r.check.value)},
                   {"limit", number(r.check.limit)},
                   {"rate", number(r.rate)},
                   {"sigma", number(r.sigma)},
                   {"approach", nameOf(r.approach)},
                   {"expected", month(r.expected)},
                   {"earliest", month(r.earliest)},
                   {"latest", month(r.latest)}});
  }
  return {{"rates", all}, {"none", rates.none.empty() ? Json(nullptr) : Json(rates.none)}};
}

}  // namespace tank_datum
