#include "scanner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "measurement.h"
#include "random.h"
#include "rotation.h"
#include "tank_curves.h"

namespace tank_datum::synth {
namespace {

constexpr std::size_t kChunkColumns = 128;  ///< measured before any of them is handed on

double rowStep(const ScannerOptions& o) { return o.row_step > 0.0 ? o.row_step : o.step; }

std::vector<StationOptions> places(const Scene& scene) {
  const ScannerOptions& o = scene.options().scanner;
  if (!o.stations.empty()) return o.stations;
  std::vector<StationOptions> all;
  const TankOptions& tank = scene.tank(o.tank).shape.options();
  const double reach = o.inside ? o.distance : tank.radius + o.distance;
  const bool full = o.arc > 2.0 * kPi - 1e-9;  // then the last would stand on the first
  for (int i = 0; i < o.count; ++i) {
    const double share = full           ? static_cast<double>(i) / o.count
                         : o.count == 1 ? 0.0
                                        : static_cast<double>(i) / (o.count - 1);
    const double azimuth = o.first_azimuth + o.arc * share;
    StationOptions place;
    place.x = tank.x + reach * portable::cos(azimuth);
    place.y = tank.y + reach * portable::sin(azimuth);
    all.push_back(place);
  }
  return all;
}

double elevationBelow(const Scene& scene, double x, double y) {
  const ScannerOptions& o = scene.options().scanner;
  if (!o.inside) return scene.ground().elevation(x, y);
  const TankOptions& tank = scene.tank(o.tank).shape.options();
  return scene.tank(o.tank).floor.elevation(x - tank.x, y - tank.y);
}

/// As listed, else drawn.
RegistrationError registrationOf(const SceneOptions& scene, std::size_t number) {
  const RegistrationOptions& o = scene.scanner.registration;
  for (const RegistrationError& error : o.errors)
    if (error.scanner == static_cast<int>(number)) return error;
  RegistrationError drawn;
  Random random({scene.seed, 603, number});
  drawn.scanner = static_cast<int>(number);
  drawn.dz = o.sigma_dz * random.gaussian();
  drawn.tilt_x = o.sigma_tilt * random.gaussian();
  drawn.tilt_y = o.sigma_tilt * random.gaussian();
  drawn.dx = o.sigma_plan * random.gaussian();
  drawn.dy = o.sigma_plan * random.gaussian();
  return drawn;
}

/// Whether the azimuth is within the angle the ring of the scanner's tank subtends, with half a metre beside it.
bool inField(const Scene& scene, const ScanStation& station, double azimuth) {
  const ScannerOptions& o = scene.options().scanner;
  const Tank& tank = scene.tank(o.tank);
  const double dx = tank.shape.options().x - station.position.x(), dy = tank.shape.options().y - station.position.y();
  const double ring = tank.shape.options().radius + tank.shape.deviation() + tank.foundation.maskWidth() + 0.5;
  const double distance = std::hypot(dx, dy);
  if (o.field == "full" || distance <= ring) return true;
  return std::abs(azimuthDifference(azimuth, portable::atan2(dy, dx))) <= portable::asin(ring / distance);
}

}  // namespace

std::vector<ScanStation> scanStations(const Scene& scene) {
  const ScannerOptions& o = scene.options().scanner;
  std::vector<ScanStation> stations;
  for (const StationOptions& place : places(scene)) {
    ScanStation s;
    s.position = {place.x, place.y, place.z};
    if (std::isnan(place.z)) s.position.z() = elevationBelow(scene, place.x, place.y) + o.height;
    s.inside = scene.tankAround(s.position);
    Random random({scene.options().seed, 601, stations.size()});
    s.first_azimuth = o.jitter ? random.uniform(0.0, 2.0 * kPi) : 0.0;
    s.first_elevation = o.min_elevation + (o.jitter ? random.uniform() * rowStep(o) : 0.0);
    s.rows = 1 + static_cast<int>(std::floor((o.max_elevation - s.first_elevation) / rowStep(o) + 1e-9));
    s.registration = registrationOf(scene.options(), stations.size());
    const int columns = static_cast<int>(std::floor(2.0 * kPi / o.step + 1e-9));
    for (int j = 0; j < columns; ++j)
      if (inField(scene, s, s.first_azimuth + j * o.step)) s.columns.push_back(j);
    stations.push_back(std::move(s));
  }
  return stations;
}

Eigen::Vector3d ScanStation::registered(const Eigen::Vector3d& point) const {
  const RegistrationError& r = registration;
  if (r.dx == 0.0 && r.dy == 0.0 && r.dz == 0.0 && r.tilt_x == 0.0 && r.tilt_y == 0.0) return point;
  // the horizontal axis across the steepest rise, turned by the angle of that rise
  const Eigen::Vector3d turn(r.tilt_y, -r.tilt_x, 0.0);
  const double angle = turn.norm();
  Eigen::Vector3d arm = point - position;
  if (angle > 0.0) arm = rotation(angle, turn / angle) * arm;
  return position + arm + Eigen::Vector3d(r.dx, r.dy, r.dz);
}

Eigen::Vector3d rayDirection(const ScannerOptions& options, const ScanStation& station, int column, int row) {
  const double azimuth = station.first_azimuth + column * options.step;
  const double elevation = station.first_elevation + row * rowStep(options);
  const auto [level_sine, level_cosine] = portable::sinCos(azimuth);
  const auto [rise, level] = portable::sinCos(elevation);
  return {level * level_cosine, level * level_sine, rise};
}

namespace {

Rows scanColumn(const Scene& scene, const ScanStation& station, std::size_t number, int column) {
  Rows rows;
  rows.reserve(4 * static_cast<std::size_t>(station.rows));
  Random random({scene.options().seed, 602, number, static_cast<std::uint64_t>(column)});
  for (int row = 0; row < station.rows; ++row) {
    const Eigen::Vector3d direction = rayDirection(scene.options().scanner, station, column, row);
    measure(scene, station, direction, random, rows);
  }
  return rows;
}

}  // namespace

ScanSummary scanScene(const Scene& scene, const RowVisitor& visit, unsigned threads) {
  ScanSummary summary;
  std::size_t number = 0;
  for (const ScanStation& station : scanStations(scene)) {
    for (std::size_t begin = 0; begin < station.columns.size(); begin += kChunkColumns) {
      const std::size_t end = std::min(begin + kChunkColumns, station.columns.size());
      std::vector<Rows> columns(end - begin);
      forEachIndex(columns.size(), static_cast<int>(threads),
                   [&](std::size_t i) { columns[i] = scanColumn(scene, station, number, station.columns[begin + i]); });
      Rows block;
      for (const Rows& rows : columns) block.insert(block.end(), rows.begin(), rows.end());
      summary.rays += (end - begin) * static_cast<std::uint64_t>(station.rows);
      summary.points += block.size() / 4;
      if (!block.empty()) visit(number, block);
    }
    ++number;
  }
  return summary;
}

}  // namespace tank_datum::synth
