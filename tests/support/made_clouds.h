#pragma once

#include <cmath>
#include <random>

#include "tank_datum/io/scan.h"

/// Clouds whose datum is known, or that have none; the same points on every machine.
namespace tank_datum::made_clouds {

inline constexpr double kTurn = 6.283185307179586;
inline constexpr double kRadius = 5.0;

/// The datum made here: a tilt of 20 mm and an oval of 6 mm amplitude [m].
inline double elevation(double a) { return 0.5 + 0.02 * std::cos(a - 1.0) + 0.006 * std::cos(2 * a); }

inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1.0p-53; }

/// A shell of 1.5 m on a pad of 1 m, one point per 16 cm2 at random places with 1 mm of noise, azimuths from 0 to
/// `arc`.
inline Points tankPoints(const Eigen::Vector3d& shift = Eigen::Vector3d::Zero(), double arc = kTurn) {
  std::mt19937_64 random(1);
  Points points;
  const auto add = [&](double a, double r, double z) {
    points.push_back(shift + Eigen::Vector3d(r * std::cos(a), r * std::sin(a), z));
  };
  const auto noise = [&] { return 0.0025 * (uniform(random) + uniform(random) - 1.0); };
  const double per_radian = kRadius / 0.0016;
  for (int i = 0; i < static_cast<int>(arc * per_radian * 1.5); ++i) {
    const double a = arc * uniform(random);
    add(a, kRadius + noise(), elevation(a) + 1.5 * uniform(random));
  }
  for (int i = 0; i < static_cast<int>(arc * per_radian * 1.1); ++i) {
    const double a = arc * uniform(random), d = uniform(random);
    add(a, kRadius + d, elevation(a) - 0.02 * d + noise());
  }
  return points;
}

/// A flat square floor of this size [m].
inline Points floorPoints(int count, double size) {
  std::mt19937_64 random(2);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = size * uniform(random), y = size * uniform(random);
    points.emplace_back(x, y, 0.003 * uniform(random));
  }
  return points;
}

/// A square room with its floor.
inline Points roomPoints() {
  std::mt19937_64 random(3);
  Points points = floorPoints(40'000, 8.0);
  for (int i = 0; i < 120'000; ++i) {
    const double along = 8.0 * uniform(random), z = 3.0 * uniform(random), off = 0.003 * uniform(random);
    const Eigen::Vector3d walls[] = {{along, off, z}, {along, 8.0 + off, z}, {off, along, z}, {8.0 + off, along, z}};
    points.push_back(walls[i % 4]);
  }
  return points;
}

}  // namespace tank_datum::made_clouds
