#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

/// Rings of points drawn at random about the origin, the same each time.
namespace tank_datum::made_rings {

/// @param Rise  how high the foot lies at an azimuth [m]
template <double (*Rise)(double)>
struct MadeRing {
  Ring ring;

  explicit MadeRing(unsigned seed) : random_(seed) { ring.reach = 0.5; }

  double any() { return any_(random_); }  ///< from 0 to 1
  double noise(double sigma) { return sigma * normal_(random_); }

  /// A point at any azimuth, so high above the foot.
  void add(double radius, double height) {
    const double a = kTwoPi * any();
    ring.points.push_back({radius * std::cos(a), radius * std::sin(a), Rise(a) + height});
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> any_;
};

/// A tank about the origin whose foot is level at 0.
inline Tank levelTank(double radius) {
  Tank tank;
  tank.circle = {{0.0, 0.0}, radius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return tank;
}

/// The stations that are measured.
inline std::vector<StationDatum> measuredOf(std::vector<StationDatum> stations) {
  stations.erase(std::remove_if(stations.begin(), stations.end(),
                                [](const StationDatum& s) { return s.flag != StationFlag::Measured; }),
                 stations.end());
  return stations;
}

}  // namespace tank_datum::made_rings
