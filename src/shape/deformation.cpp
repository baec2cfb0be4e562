#include "shape/deformation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/azimuth.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "shape/datum_waves.h"
#include "shape/partial_ring_tilt.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

bool known(const Station& station) { return station.flag != StationFlag::Missing && std::isfinite(station.z); }

/// Two stations across a diameter, the first in their order before the second.
struct Diameter {
  std::size_t first, second;
};

/// The diameters in the order of their first stations; those that have no station across are in none.
std::vector<Diameter> diametersOf(const std::vector<Station>& stations) {
  constexpr double kSame = 1e-6;  // [rad]
  std::vector<std::pair<double, std::size_t>> places;
  for (std::size_t i = 0; i < stations.size(); ++i) places.push_back({withinTurn(stations[i].azimuth), i});
  std::sort(places.begin(), places.end());
  std::vector<Diameter> diameters;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double across = withinTurn(stations[i].azimuth + kPi - kSame);
    auto at = std::lower_bound(places.begin(), places.end(), std::pair(across, std::size_t{0}));
    if (at == places.end()) at = places.begin();
    const double apart = std::remainder(at->first - stations[i].azimuth - kPi, kTwoPi);
    if (std::abs(apart) <= 1.5 * kSame && at->second > i) diameters.push_back({i, at->second});
  }
  return diameters;
}

}  // namespace

double Antipodal::angle() const { return portable::atan(max_h / diameter); }

Level levelOf(const std::vector<Station>& stations) {
  Level level;
  double sum = 0;
  for (const Station& s : stations) {
    (s.flag == StationFlag::Measured       ? level.measured
     : s.flag == StationFlag::Interpolated ? level.interpolated
                                           : level.missing)++;
    if (!known(s)) continue;
    sum += s.z;
    if (!(s.z >= level.min)) level.min = s.z, level.min_azimuth = s.azimuth;
    if (!(s.z <= level.max)) level.max = s.z, level.max_azimuth = s.azimuth;
  }
  level.mean = sum / static_cast<double>(level.measured + level.interpolated);
  return level;
}

std::vector<double> antipodalHeights(const std::vector<Station>& stations) {
  std::vector<double> heights;
  for (const auto& [first, second] : diametersOf(stations)) {
    const Station &a = stations[first], &b = stations[second];
    heights.push_back(known(a) && known(b) ? a.z - b.z : kUnknown);
  }
  return heights;
}

Antipodal antipodalOf(const std::vector<Station>& stations) {
  Antipodal result;
  for (const auto& [first, second] : diametersOf(stations)) {
    const Station &a = stations[first], &b = stations[second];
    const double height = a.z - b.z;
    if (!known(a) || !known(b) || std::abs(height) <= result.max_h) continue;
    result.max_h = std::abs(height);
    result.sigma = std::hypot(a.sigma_z, b.sigma_z);
    result.diameter = std::hypot(a.x - b.x, a.y - b.y);
    result.azimuth = height >= 0.0 ? a.azimuth : b.azimuth;
  }
  return result;
}

namespace {

/// The figures of the regression that go with a plane.
void describePlane(const std::vector<Station>& stations, const std::vector<StationTilt>& standings, Tilt& tilt) {
  const std::vector<double> weights = waveData(stations, 1).weights;
  double sum = 0, total_weight = 0, residual = 0, total = 0;
  auto weight = weights.begin();
  for (const Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    sum += *weight * s.z;
    total_weight += *weight++;
  }
  weight = weights.begin();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[i];
    if (!known(s) || s.flag != StationFlag::Measured) continue;
    residual += *weight * standings[i].u * standings[i].u;
    total += *weight++ * square(s.z - sum / total_weight);
  }
  const auto n = static_cast<double>(weights.size());
  tilt.standard_error = std::sqrt(residual / (n - 3.0) * n / total_weight);
  constexpr double kNanometre = 1e-9;  // a datum level to within rounding has no variance to explain
  tilt.r2 = total > total_weight * kNanometre * kNanometre ? std::max(0.0, 1.0 - residual / total) : kUnknown;
  // P(F > f) for 2 and m degrees of freedom is (1 + 2 f / m)^(-m/2), and f = (r2/2) / ((1-r2)/m), hence:
  tilt.p_value = portable::pow(1.0 - tilt.r2, (n - 3.0) / 2.0);
}

/// Whether the measured stations are enough, and not in one line.
bool spanPlane(const std::vector<Station>& stations, const Eigen::Vector2d& center) {
  constexpr int kFewestStations = 4;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  int count = 0;
  for (const Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    const Eigen::Vector3d row(1.0, s.x - center.x(), s.y - center.y());
    normal += row * row.transpose();
    ++count;
  }
  return count >= kFewestStations && Eigen::FullPivLU<Eigen::Matrix3d>(normal).isInvertible();
}

}  // namespace

std::vector<StationTilt> standingsTo(const Tilt& tilt, const std::vector<Station>& stations,
                                     const Eigen::Vector2d& center) {
  std::vector<StationTilt> standings;
  for (const Station& s : stations) {
    standings.emplace_back();
    if (!tilt.valid() || !known(s)) continue;
    StationTilt& standing = standings.back();
    standing.z_tilt = tilt.mean + tilt.gradient.x() * (s.x - center.x()) + tilt.gradient.y() * (s.y - center.y());
    standing.u = s.z - standing.z_tilt;
  }
  return standings;
}

Tilt fitTilt(const std::vector<Station>& stations, const Eigen::Vector2d& center, const StationOptions& options,
             const StationCovariance& covariance) {
  Tilt tilt;
  if (!spanPlane(stations, center)) return tilt;
  const PlaneFit fit = fitPlane(stations, center, covariance);
  tilt.mean = fit.plane[0];
  tilt.gradient = fit.plane.tail<2>();
  describePlane(stations, standingsTo(tilt, stations, center), tilt);
  const double up = portable::atan2(fit.plane[2], fit.plane[1]);
  tilt.direction = azimuthOf(up, options);
  const Eigen::Matrix2d spread = fit.covariance.bottomRightCorner<2, 2>();
  const Eigen::Vector2d along(portable::cos(up), portable::sin(up));
  tilt.sigma_slope = std::sqrt(along.dot(spread * along));
  tilt.freedom = fit.freedom;
  tilt.covariance = spread;
  if (hasTiltingGap(stations))  // chi-square of 2
    tilt.p_value = portable::exp(-0.5 * tilt.gradient.dot(spread.inverse() * tilt.gradient));
  return tilt;
}

}  // namespace tank_datum
