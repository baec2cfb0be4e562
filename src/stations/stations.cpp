#include "stations/stations.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
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

const char* nameOf(Unmeasured reason) {
  switch (reason) {
    case Unmeasured::None:
      return "";
    case Unmeasured::NoShell:
      return "no_shell";
    case Unmeasured::Hidden:
      return "hidden";
    case Unmeasured::OtherSurface:
      return "other_surface";
    case Unmeasured::OffCircle:
      return "off_circle";
    case Unmeasured::ShellBelow:
      return "shell_below";
  }
  return "";
}

double azimuthOf(double direction, const StationOptions& options) {
  return withinTurn((direction - options.zero_azimuth) * (options.clockwise ? -1.0 : 1.0));
}

double directionOf(double azimuth, const StationOptions& options) {
  return withinTurn(options.zero_azimuth + (options.clockwise ? -azimuth : azimuth));
}

std::vector<Station> emptyStations(const StationOptions& options) {
  std::vector<Station> stations(static_cast<std::size_t>(options.count));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].azimuth = kTwoPi * static_cast<double>(i) / options.count;
    stations[i].direction = directionOf(stations[i].azimuth, options);
  }
  return stations;
}

std::vector<StationFlag> flagsOf(const std::vector<bool>& supported, const StationOptions& options) {
  const std::size_t count = supported.size();
  std::vector<StationFlag> flags;
  std::vector<char> missing;
  for (const bool here : supported) {
    flags.push_back(here ? StationFlag::Measured : StationFlag::Missing);
    missing.push_back(here ? 0 : 1);
  }
  for (const RingRun& gap : runsRound(missing)) {
    const std::size_t length = gap.last - gap.first + 1;
    if (length == count) continue;  // nothing to bridge from
    if (static_cast<double>(length) * kTwoPi / static_cast<double>(count) > options.longest_bridge + 1e-12) continue;
    for (std::size_t i = gap.first; i <= gap.last; ++i) flags[i % count] = StationFlag::Interpolated;
  }
  return flags;
}

namespace {

/// What the measured stations on both sides of a station in a gap say of it.
struct Beside {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< of heights, by the stations' standard errors
  Eigen::Vector3d heights = Eigen::Vector3d::Zero(), radii = Eigen::Vector3d::Zero();
  double nearest[2] = {0.0, 0.0};  ///< arcs to the nearest measured station on either side [m]
  double sigma_radius = 0.0;       ///< mean of their radii's standard errors [m]
  double sigma_z = 0.0;            ///< mean of their standard errors, which share more than noise [m]
};

/// @param sigma_bend  of the datum's second derivative along the shell [1/m]: how far a parabola is good
Beside lookBeside(const std::vector<StationDatum>& stations, std::size_t at, double sigma_bend) {
  constexpr std::size_t kReach = 12;  // stations beside a gap that its parabola leans on
  const std::size_t count = stations.size();
  Beside beside;
  for (const int way : {-1, 1}) {
    std::size_t used = 0;
    for (std::size_t away = 1; away < count / 2 && used < kReach; ++away) {
      const StationDatum& other = stations[(at + (way > 0 ? away : count - away)) % count];
      if (other.flag != StationFlag::Measured) continue;
      const double t = way * static_cast<double>(away) * kTwoPi / static_cast<double>(count) * other.radius;
      if (used++ == 0) {
        beside.nearest[way > 0] = std::abs(t);
        beside.sigma_z += 0.5 * other.sigma_z;
        beside.sigma_radius += 0.5 * other.sigma_radius;
      }
      const Eigen::Vector3d row(1.0, t, t * t);
      const double bent = 0.5 * sigma_bend * t * t;
      const double weight = 1.0 / (other.sigma_z * other.sigma_z + bent * bent);
      beside.normal += weight * row * row.transpose();
      beside.scatter += square(weight * other.sigma_z) * row * row.transpose();
      beside.heights += weight * other.z * row;
      beside.radii += weight * other.radius * row;
    }
  }
  return beside;
}

}  // namespace

std::vector<StationDatum> bridgeGaps(const std::vector<StationDatum>& stations, const Eigen::Vector2d& center,
                                     double sigma_bend) {
  std::vector<StationDatum> bridged = stations;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    StationDatum& s = bridged[i];
    if (s.flag != StationFlag::Interpolated) continue;
    const Beside beside = lookBeside(stations, i, sigma_bend);
    const Eigen::Matrix3d inverse = beside.normal.inverse();
    s.z = inverse.row(0).dot(beside.heights);
    const double scatter = inverse.row(0) * beside.scatter * inverse.row(0).transpose();
    s.sigma_z = std::hypot(std::max(beside.sigma_z, std::sqrt(scatter)),
                           0.5 * sigma_bend * beside.nearest[0] * beside.nearest[1]);
    s.radius = inverse.row(0).dot(beside.radii);
    s.sigma_radius = beside.sigma_radius;
    s.x = center.x() + s.radius * portable::cos(s.direction);
    s.y = center.y() + s.radius * portable::sin(s.direction);
  }
  return bridged;
}

std::vector<StationDatum> samplePaperCurve(const std::vector<Station>& stations, const ClosedSpline& curve,
                                           const EdgePoints& edge, const StationOptions& options) {
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
  const std::vector<StationFlag> flags = flagsOf(supported, options);
  std::vector<StationDatum> sampled(stations.begin(), stations.end());
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    StationDatum& s = sampled[i];
    s.flag = flags[i];
    if (s.flag == StationFlag::Missing) continue;
    const Eigen::Vector3d point = curve.at(s.direction);
    s.radius = (point.head<2>() - edge.circle.center).norm();
    s.x = edge.circle.center.x() + s.radius * portable::cos(s.direction);
    s.y = edge.circle.center.y() + s.radius * portable::sin(s.direction);
    s.z = point.z();
  }
  return sampled;
}

}  // namespace tank_datum
