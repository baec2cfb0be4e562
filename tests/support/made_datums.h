#pragma once

#include <cmath>

#include "core/units.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/report/report.h"

/// A result made by hand, for the tests of what is written.
namespace tank_datum::made_datums {

/// Eight stations of a 10 m tank far from the frame's zero: the sixth interpolated, the seventh missing.
inline Datum octagon() {
  Datum datum;
  datum.status = Status::Partial;
  datum.message = "1 of 8 stations are missing: the datum is not measured there";
  datum.origin = {500000.5, 4000000.25, 100.125};
  datum.tank.circle = datum.circle = datum.refined.circle = {{1.0, 2.0}, 10.0};
  datum.tank.rms = 0.004;
  datum.tank.coverage = 350 * kDegree;
  datum.refined.sigma_radius = 0.0001;
  datum.refined.profile.surface = Surface::AnnularPlate;
  datum.refined.profile.band_from = 0.015, datum.refined.profile.band_to = 0.06;
  StationOptions options;
  options.count = 8;
  datum.stations = emptyStations(options);
  for (std::size_t i = 0; i < 8; ++i) {
    Station& s = datum.stations[i];
    s.flag = i == 6 ? StationFlag::Missing : i == 5 ? StationFlag::Interpolated : StationFlag::Measured;
    if (i == 6) continue;
    s.x = 1.0 + 10.0 * std::cos(s.direction), s.y = 2.0 + 10.0 * std::sin(s.direction);
    s.z = 0.5 + 0.001 * static_cast<double>(i), s.sigma_z = 0.00025;
    s.z_paper = s.z + 0.01;
    s.radius = 10.0, s.sigma_radius = 0.0005;
    s.n_shell = 100 + i, s.n_foundation = 50 + i;
  }
  datum.edge_points = {{11.0, 2.0, 0.51}, {1.0, 12.0, 0.52}};
  datum.level = levelOf(datum.stations);
  datum.tilt = fitTilt(datum.stations, datum.circle.center, options);
  datum.stations = withParts(datum.stations, standingsTo(datum.tilt, datum.stations, datum.circle.center));
  datum.antipodal = antipodalOf(datum.stations);
  return datum;
}

inline Provenance provenance() {
  Provenance from;
  from.files = {{"a.pcd", 17, Checksum::Sha256, "abc"}, {"b\xff.pcd", 4, Checksum::Sha256, "def"}};
  from.units = "mm";
  from.invalid_points = 3;
  return from;
}

}  // namespace tank_datum::made_datums
