#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "foot/refine.h"
#include "locate/crop.h"
#include "stations/stations.h"
#include "support/scanned_tanks.h"

/// Scans refined and compared with their truth.
namespace tank_datum::refined_scans {

using namespace scanned_tanks;

/// A scene refined: its stations in the scene's own frame, and how they compare with the truth.
struct Scanned {
  std::vector<Station> stations;
  Refined refined;
  synth::TruthTank truth;
  double rms = 0, largest = 0, within_2_sigma = 0;
  std::size_t measured = 0;

  const synth::TruthStation& truthAt(const Station& s) const {
    const auto count = static_cast<double>(truth.stations.size());
    return truth.stations[static_cast<std::size_t>(std::lround(s.direction / kTurn * count)) % truth.stations.size()];
  }
};

inline Scanned run(const SceneOptions& scene, const Points& points, const RefineOptions& options = {},
                   const StationOptions& station_options = {}) {
  Scanned result;
  result.truth = truthOf(scene);
  const Scan scan = Scan::fromPoints(points);
  const Tank tank = roughTank(scene, scan.origin());
  const Ring ring = cropRing(scan, tank, {});
  const RefinedFoot foot = refineStations(ring, tank, options, station_options);
  result.stations = withParts(emptyStations(station_options), foot.stations);
  result.refined = foot.refined;
  result.refined.circle.center += scan.origin().head<2>();
  double squares = 0, within = 0;
  for (Station& s : result.stations) {
    s.x += scan.origin().x(), s.y += scan.origin().y(), s.z += scan.origin().z();
    if (s.flag != StationFlag::Measured) continue;
    const double error = s.z - result.truthAt(s).z;
    squares += error * error;
    within += std::abs(error) < 2.0 * s.sigma_z;
    result.largest = std::max(result.largest, std::abs(error));
    ++result.measured;
  }
  result.rms = std::sqrt(squares / static_cast<double>(result.measured));
  result.within_2_sigma = within / static_cast<double>(result.measured);
  return result;
}

inline const Points& padPoints() {
  static const Points points = pointsOf(tank20());
  return points;
}
inline const Scanned& padRun() {
  static const Scanned result = run(tank20(), padPoints());
  return result;
}

}  // namespace tank_datum::refined_scans
