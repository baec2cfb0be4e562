#include "report/sighting_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_number.h"

namespace tank_datum {

using Json = nlohmann::ordered_json;

std::string sightingJson(const Datum& datum) {
  constexpr double kStep = 1e-3;  // finer than a picture shows [m]
  const Sighting& sighting = datum.sighting;
  const bool tried = sighting.circle.valid();
  Eigen::Vector3d from = sighting.points.empty() ? Eigen::Vector3d::Zero() : sighting.points.front();
  if (tried) from.head<2>() = sighting.circle.center;
  if (std::isfinite(sighting.foot)) from.z() = sighting.foot;
  Json x = Json::array(), y = Json::array(), z = Json::array();
  for (const Eigen::Vector3d& p : sighting.points) {
    x.push_back(std::lround((p.x() - from.x()) / kStep));
    y.push_back(std::lround((p.y() - from.y()) / kStep));
    z.push_back(std::lround((p.z() - from.z()) / kStep));
  }
  const Eigen::Vector3d origin = from + datum.origin;
  const Json json = {{"step", kStep},
                     {"from", {origin.x(), origin.y(), origin.z()}},
                     {"radius", tried ? Json(sighting.circle.radius) : Json(nullptr)},
                     {"foot", number(sighting.foot + datum.origin.z())},
                     {"x", x},
                     {"y", y},
                     {"z", z}};
  return json.dump() + "\n";
}

}  // namespace tank_datum
