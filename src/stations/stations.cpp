#include "tank_datum/stations/stations.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

double wrapped(double azimuth) { return azimuth - kTwoPi * std::floor(azimuth / kTwoPi); }

}  // namespace

const char* nameOf(StationFlag flag) {
  switch (flag) {
    case StationFlag::Measured:
      return "measured";
    case StationFlag::Interpolated:
      return "interpolated";
    case StationFlag::Missing:
      return "missing";
  }
  return "";
}

std::vector<Station> emptyStations(const StationOptions& options) {
  std::vector<Station> stations(static_cast<std::size_t>(options.count));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].azimuth = kTwoPi * static_cast<double>(i) / options.count;
    stations[i].direction =
        wrapped(options.zero_azimuth + (options.clockwise ? -stations[i].azimuth : stations[i].azimuth));
  }
  return stations;
}

void flagGaps(std::vector<Station>& stations, const std::vector<bool>& supported, const StationOptions& options) {
  const std::size_t count = stations.size();
  for (std::size_t i = 0; i < count; ++i) {
    stations[i].flag = supported[i] ? StationFlag::Measured : StationFlag::Missing;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!supported[i] || supported[(i + 1) % count]) continue;  // i is the last one before a gap
    std::size_t gap = 1;
    while (gap < count && !supported[(i + 1 + gap) % count]) ++gap;
    if (static_cast<double>(gap) * kTwoPi / static_cast<double>(count) > options.longest_bridge + 1e-12) continue;
    for (std::size_t j = 1; j <= gap; ++j) stations[(i + j) % count].flag = StationFlag::Interpolated;
  }
}

void bridgeGaps(std::vector<Station>& stations, const Eigen::Vector2d& center, double sigma_bend) {
  constexpr std::size_t kReach = 12;  // stations beside a gap that its parabola leans on
  const std::size_t count = stations.size();
  for (std::size_t i = 0; i < count; ++i) {
    Station& s = stations[i];
    if (s.flag != StationFlag::Interpolated) continue;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d heights = Eigen::Vector3d::Zero(), radii = Eigen::Vector3d::Zero();
    double nearest[2] = {0.0, 0.0};  // arcs to the nearest measured station on either side [m]
    double beside_radius = 0.0;      // the same of their radii [m]
    double beside = 0.0;             // mean of their standard errors, which share more than noise [m]
    for (const int way : {-1, 1}) {
      std::size_t used = 0;
      for (std::size_t away = 1; away < count / 2 && used < kReach; ++away) {
        const Station& other = stations[(i + (way > 0 ? away : count - away)) % count];
        if (other.flag != StationFlag::Measured) continue;
        const double t = way * static_cast<double>(away) * kTwoPi / static_cast<double>(count) * other.radius;
        if (used++ == 0) {
          nearest[way > 0] = std::abs(t);
          beside += 0.5 * other.sigma_z;
          beside_radius += 0.5 * other.sigma_radius;
        }
        const Eigen::Vector3d row(1.0, t, t * t);
        const double weight = 1.0 / (other.sigma_z * other.sigma_z);
        normal += weight * row * row.transpose();
        heights += weight * other.z * row;
        radii += weight * other.radius * row;
      }
    }
    const Eigen::Matrix3d inverse = normal.inverse();
    s.z = inverse.row(0).dot(heights);
    s.sigma_z = std::hypot(std::max(beside, std::sqrt(inverse(0, 0))), 0.5 * sigma_bend * nearest[0] * nearest[1]);
    s.radius = inverse.row(0).dot(radii);
    s.sigma_radius = beside_radius;
    s.x = center.x() + s.radius * std::cos(s.direction);
    s.y = center.y() + s.radius * std::sin(s.direction);
  }
}

void samplePaperCurve(std::vector<Station>& stations, const ClosedSpline& curve, const EdgePoints& edge,
                      const StationOptions& options) {
  const double half = std::max(kTwoPi / 360.0, kTwoPi / options.count) / 2.0;
  const auto any_between = [&](double low, double high) {
    const auto at = std::lower_bound(edge.azimuths.begin(), edge.azimuths.end(), low);
    return at != edge.azimuths.end() && *at <= high;
  };
  std::vector<bool> supported;
  for (const Station& s : stations) {
    const double low = s.direction - half, high = s.direction + half;
    supported.push_back(any_between(low, high) || any_between(low + kTwoPi, high + kTwoPi) ||
                        any_between(low - kTwoPi, high - kTwoPi));
  }
  flagGaps(stations, supported, options);
  for (Station& s : stations) {
    if (s.flag == StationFlag::Missing) continue;
    const Eigen::Vector3d point = curve.at(s.direction);
    s.radius = (point.head<2>() - edge.circle.center).norm();
    s.x = edge.circle.center.x() + s.radius * std::cos(s.direction);
    s.y = edge.circle.center.y() + s.radius * std::sin(s.direction);
    s.z = s.z_paper = point.z();
    s.sigma_z = s.sigma_radius = kUnknown;
  }
}

}  // namespace tank_datum
