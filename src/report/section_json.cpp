#include "report/section_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStep =
    1e-4;  // of the points' coordinates: finer than a scanner's noise, coarse enough to be short [m]

/// Six significant figures: what a line needs over half a metre.
Json figure(double value) {
  if (!std::isfinite(value)) return nullptr;
  if (value == 0.0) return 0.0;
  const double scale = portable::pow(10.0, 5.0 - std::floor(portable::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json sectionJson(const StationProfile& section, double origin) {
  Json d = Json::array(), z = Json::array();
  for (const SectionPoint& p : section.points) {
    d.push_back(std::lround(p.d / kStep));
    z.push_back(std::lround(p.z / kStep));
  }
  return {{"base", section.base + origin},
          {"foundation", figure(section.foundation)},
          {"slope", figure(section.slope)},
          {"noise", figure(section.noise)},
          {"lean", figure(section.lean)},
          {"shell_noise", figure(section.shell_noise)},
          {"d", d},
          {"z", z}};
}

}  // namespace

std::string sectionsJson(const Datum& datum) {
  const FootProfile& profile = datum.refined.profile;
  Json stations = Json::array();
  for (const StationProfile& section : datum.refined.sections) {
    stations.push_back(sectionJson(section, datum.origin.z()));
  }
  const Json json = {{"step", kStep},
                     {"side", datum.tank.side == Side::Inside ? "inside" : "outside"},
                     {"band", {figure(profile.band_from), figure(profile.band_to)}},
                     {"edge", figure(profile.edge)},
                     {"stations", stations}};
  return json.dump() + "\n";
}

}  // namespace tank_datum
