#include "truth.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "scene_file.h"
#include "tank_curves.h"
#include "truth_shell.h"

namespace tank_datum::synth {
namespace {

using Json = nlohmann::ordered_json;

/// A place in the open just before the crease.
Eigen::Vector3d beforeCrease(const Tank& tank, const Eigen::Vector3d& crease, bool inside) {
  const TankOptions& o = tank.shape.options();
  const double off = o.foundation.weld + 0.002 + tank.foundation.noise().bound(), out = inside ? -off : off;
  const Eigen::Vector2d way = (crease.head<2>() - Eigen::Vector2d(o.x, o.y)).normalized();
  return crease + Eigen::Vector3d(out * way.x(), out * way.y(), off);
}

bool sees(const Scene& scene, const ScanStation& from, int tank, const Eigen::Vector3d& place) {
  const ScannerOptions& o = scene.options().scanner;
  if (from.inside >= 0 && from.inside != tank) return false;
  const Eigen::Vector3d way = place - from.position;
  const double distance = way.norm(), elevation = portable::asin(way.z() / distance);
  if (distance > o.max_range || elevation < o.min_elevation || elevation > o.max_elevation) return false;
  return !scene.cast({from.position, way / distance}, from.inside, distance).found();
}

/// The middle of a tank's base in the output's frame, without the offset.
Eigen::Vector3d centreInFrame(const Scene& scene, const TankOptions& tank) {
  return scene.inFrame({tank.x, tank.y, tank.base_elevation});
}

/// The azimuth about a tank at which its datum lies at some azimuth of the output's frame [rad].
double azimuthOnTank(const Scene& scene, const Tank& tank, double azimuth, bool inside) {
  constexpr int kSteps = 4;  // each leaves a thousandth: a tilt of some degrees moves azimuths by its square
  const Eigen::Vector3d centre = centreInFrame(scene, tank.shape.options());
  double own = azimuth;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d arm = scene.inFrame(tank.datumPoint(own, inside)) - centre;
    own -= std::remainder(portable::atan2(arm.y(), arm.x()) - azimuth, 2.0 * kPi);
  }
  return own;
}

TruthTank truthOfTank(const Scene& scene, const std::vector<ScanStation>& scanners, int index, int stations) {
  const Tank& tank = scene.tank(index);
  TruthTank truth;
  truth.options = tank.shape.options();
  truth.inside = std::any_of(scanners.begin(), scanners.end(), [&](const auto& s) { return s.inside == index; });
  const auto& offset = scene.options().offset;
  const bool tilted = scene.options().frame_tilt != 0.0;
  const Eigen::Vector3d centre = centreInFrame(scene, truth.options);
  truth.x = centre.x() + offset[0], truth.y = centre.y() + offset[1];
  for (int k = 0; k < stations; ++k) {
    TruthStation s;
    s.azimuth = 2.0 * kPi * k / stations;
    const double own = tilted ? azimuthOnTank(scene, tank, s.azimuth, truth.inside) : s.azimuth;
    const Eigen::Vector3d crease = tank.datumPoint(own, truth.inside), said = scene.inFrame(crease);
    s.radius = (said - centre).head<2>().norm();
    const bool ground =
        scene.options().ground.over_foundation && scene.ground().elevation(crease.x(), crease.y()) > crease.z();
    s.covered = !truth.inside && (ground || tank.foundation.buried(own));
    const Eigen::Vector3d open = beforeCrease(tank, crease, truth.inside);
    s.visible =
        std::any_of(scanners.begin(), scanners.end(), [&](const auto& f) { return sees(scene, f, index, open); });
    s.x = said.x() + offset[0], s.y = said.y() + offset[1], s.z = said.z() + offset[2];
    truth.stations.push_back(s);
  }
  addShellTruth(tank, stations, {offset[0], offset[1]}, truth);
  return truth;
}

std::string surfaceName(const TruthTank& tank) {
  if (tank.inside) return "floor";
  const std::string& kind = tank.options.foundation.kind;
  return kind == "pad" ? "foundation" : "annular_plate";
}

Json stationsJson(const TruthTank& tank) {
  Json list = Json::array();
  for (const TruthStation& s : tank.stations)
    list.push_back({{"azimuth_deg", degrees(s.azimuth)},
                    {"x", s.x},
                    {"y", s.y},
                    {"z", s.z},
                    {"radius", s.radius},
                    {"covered", s.covered},
                    {"visible", s.visible}});
  return list;
}

Json tankJson(const TruthTank& tank, const std::array<double, 3>& offset) {
  const TankOptions& o = tank.options;
  const auto byZ = [](const TruthStation& a, const TruthStation& b) { return a.z < b.z; };
  const auto ends = std::minmax_element(tank.stations.begin(), tank.stations.end(), byZ);
  Json harmonics = Json::array(), arcs = Json::array();
  for (const Harmonic& h : o.harmonics)
    harmonics.push_back({{"n", h.n}, {"amplitude", h.amplitude}, {"phase_deg", degrees(h.phase)}});
  for (const Soil& soil : o.soil)
    arcs.push_back({{"azimuth_deg", degrees(soil.azimuth)}, {"width_deg", degrees(soil.width)}, {"depth", soil.depth}});
  Json json;
  json["center"] = {tank.x, tank.y};
  json["radius"] = tank.inside ? o.radius - o.thickness : o.radius;
  json["side"] = tank.inside ? "inside" : "outside";
  json["surface"] = surfaceName(tank);
  json["z0"] = o.base_elevation + offset[2];
  json["min"] = ends.first->z;
  json["max"] = ends.second->z;
  json["tilt"] = {{"slope", tiltSlope(o)}, {"direction_deg", degrees(o.tilt_direction)}};
  json["harmonics"] = harmonics;
  json["soil_arcs"] = arcs;
  json["shell"] = shellTruthJson(tank);
  json["stations"] = stationsJson(tank);
  return json;
}

Json registrationJson(const Truth& truth, std::size_t scanner) {
  const RegistrationError& r = truth.registration[scanner];
  const auto arcsec = [](double angle) { return 3600.0 * degrees(angle); };
  return {{"dx", r.dx},
          {"dy", r.dy},
          {"dz", r.dz},
          {"tilt_x_arcsec", arcsec(r.tilt_x)},
          {"tilt_y_arcsec", arcsec(r.tilt_y)}};
}

}  // namespace

Truth truthOf(const Scene& scene, int stations) {
  Truth truth;
  truth.options = scene.options();
  const auto& offset = truth.options.offset;
  const std::vector<ScanStation> scanners = scanStations(scene);
  for (const ScanStation& s : scanners) {
    truth.scanners.push_back(scene.inFrame(s.position) + Eigen::Vector3d(offset[0], offset[1], offset[2]));
    truth.registration.push_back(s.registration);
  }
  for (int i = 0; i < static_cast<int>(scene.tanks().size()); ++i)
    truth.tanks.push_back(truthOfTank(scene, scanners, i, stations));
  return truth;
}

Json toJson(const Truth& truth) {
  Json json;
  json["seed"] = truth.options.seed;
  json["options"] = toJson(truth.options);
  json["scanners"] = Json::array();
  for (std::size_t i = 0; i < truth.scanners.size(); ++i) {
    const Eigen::Vector3d& s = truth.scanners[i];
    json["scanners"].push_back(
        {{"x", s.x()}, {"y", s.y()}, {"z", s.z()}, {"registration", registrationJson(truth, i)}});
  }
  json["tanks"] = Json::array();
  for (const TruthTank& tank : truth.tanks) json["tanks"].push_back(tankJson(tank, truth.options.offset));
  return json;
}

}  // namespace tank_datum::synth
