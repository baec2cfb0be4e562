#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"

/// Stations made by hand, for the tests of what their elevations mean.
namespace tank_datum::made_surveys {

inline constexpr double kTurn = 6.283185307179586;

/// Their tilt, and the stations with their places to its plane.
inline Tilt takeTilt(std::vector<Station>& stations, const Eigen::Vector2d& center, const StationOptions& options) {
  const Tilt tilt = fitTilt(stations, center, options);
  stations = withParts(stations, standingsTo(tilt, stations, center));
  return tilt;
}

/// Measured stations about the origin with these elevations; NaN is missing. Their tilt is taken out.
inline std::vector<Station> survey(const std::vector<double>& z, double radius, double sigma = kUnknown) {
  StationOptions options;
  options.count = static_cast<int>(z.size());
  std::vector<Station> stations = emptyStations(options);
  for (std::size_t i = 0; i < z.size(); ++i) {
    Station& s = stations[i];
    s.radius = radius;
    s.x = radius * std::cos(s.direction);
    s.y = radius * std::sin(s.direction);
    if (std::isnan(z[i])) continue;
    s.z = z[i];
    s.sigma_z = sigma;
    s.flag = StationFlag::Measured;
  }
  takeTilt(stations, {0.0, 0.0}, options);
  return stations;
}

/// Elevations at equal steps round the tank.
template <typename Shape>
std::vector<double> wave(std::size_t count, Shape z) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(z(kTurn * static_cast<double>(i) / static_cast<double>(count)));
  return values;
}

inline std::vector<double> noisy(std::vector<double> values, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0.0, sigma);
  for (double& v : values) v += noise(generator);
  return values;
}

}  // namespace tank_datum::made_surveys
