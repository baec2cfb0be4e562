#include "tank_datum/shape/out_of_plane.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "shape/datum_waves.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kShortestHalfWave = 6.096;  // 20 ft [m]
constexpr double kSmallestDiameter = 18.6;   // 61 ft [m]
constexpr std::size_t kFewest = 65;          // stations: "more than 64"
constexpr int kLeastOrder = 4;

int shortestWave(double radius) { return static_cast<int>(std::floor(kPi * radius / kShortestHalfWave)); }

/// 1 - (what an order leaves) / (what the plane leaves), each over its degrees of freedom.
double adjustedR2(const WaveData& data, int order) {
  const auto n = static_cast<double>(data.count());
  const double left = residualSum(data, fitHarmonics(data.azimuths, data.z, data.weights, order, false, 0.0));
  const double plane = residualSum(data, fitHarmonics(data.azimuths, data.z, data.weights, 1, false, 0.0));
  return 1.0 - left / (n - 2.0 * order - 1.0) / (plane / (n - 3.0));
}

int chosenOrder(const WaveData& data, int highest) {
  int order = std::min(kLeastOrder, highest);
  while (order < highest && adjustedR2(data, order + 1) > adjustedR2(data, order)) ++order;
  return order;
}

/// The row that gives the second derivative of the waves n >= 2 along the shell.
Eigen::RowVectorXd curvatureRow(double azimuth, int order, double radius) {
  Eigen::RowVectorXd row = harmonicRow(azimuth, order);
  row.head<3>().setZero();
  for (int n = 2; n <= order; ++n) row.segment<2>(2 * n - 1) *= -(n / radius) * (n / radius);
  return row;
}

Eigen::RowVectorXd bendingRow(double azimuth, int order) {
  Eigen::RowVectorXd row = harmonicRow(azimuth, order);
  row.head<3>().setZero();
  return row;
}

double sigmaOf(const Eigen::RowVectorXd& row, const PeriodicFit& fit) {
  return std::sqrt(std::max(0.0, row.dot(fit.covariance * row.transpose())));
}

void describe(std::vector<Station>& stations, const PeriodicFit& fit, double radius, OutOfPlane& result) {
  for (Station& s : stations) {
    if (!std::isfinite(s.u)) continue;
    const Eigen::RowVectorXd bent = curvatureRow(s.azimuth, fit.order(), radius);
    s.u_fit = fit(s.azimuth) - s.z_tilt;
    s.sigma_u_fit = sigmaOf(bendingRow(s.azimuth, fit.order()), fit);
    s.curvature = bent * fit.coefficients;
    s.sigma_curvature = sigmaOf(bent, fit);
    if (std::abs(s.curvature) <= result.max_curvature) continue;
    result.max_curvature = std::abs(s.curvature);
    result.sigma_curvature = s.sigma_curvature;
    result.max_curvature_azimuth = s.azimuth;
  }
}

double rmsLeft(const std::vector<Station>& stations) {
  double sum = 0, count = 0;
  for (const Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    sum += (s.u - s.u_fit) * (s.u - s.u_fit);
    count += 1;
  }
  return std::sqrt(sum / count);
}

}  // namespace

std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius) {
  constexpr int kAlways = 6;
  const WaveData rough = waveData(stations, 1);
  const int order = highestOrder(rough, std::max(kAlways, shortestWave(radius)), kAlways);
  std::vector<Harmonic> harmonics;
  if (rough.count() < 4 || order < 1) return harmonics;
  const PeriodicFit fit = fitWaves(waveData(stations, order), order);
  harmonics.push_back({0, fit.coefficients[0], kUnknown, std::sqrt(fit.covariance(0, 0))});
  for (int n = 1; n <= order; ++n) {
    const Eigen::Vector2d wave = fit.coefficients.segment<2>(2 * n - 1);
    const double amplitude = wave.norm(), phase = std::atan2(wave.y(), wave.x());
    const Eigen::Vector2d along(std::cos(phase), std::sin(phase));
    const double variance = along.dot(fit.covariance.block<2, 2>(2 * n - 1, 2 * n - 1) * along);
    harmonics.push_back({n, amplitude, (phase < 0.0 ? phase + kTwoPi : phase) / n, std::sqrt(std::max(0.0, variance))});
  }
  return harmonics;
}

OutOfPlane fitOutOfPlane(std::vector<Station>& stations, double radius) {
  OutOfPlane result;
  for (const Station& s : stations) {
    if (!std::isfinite(s.u) || std::abs(s.u) <= result.max_u) continue;
    result.max_u = std::abs(s.u);
    result.max_u_azimuth = s.azimuth;
  }
  const int longest = std::max(kLeastOrder, shortestWave(radius));
  const WaveData data = waveData(stations, std::min(longest, static_cast<int>(stations.size()) / 8));
  if (!std::isfinite(result.max_u)) return result;
  if (data.count() < kFewest) {
    result.message = std::to_string(data.count()) + " stations measured; trigonometric regression is for more than 64";
    return result;
  }
  if (2.0 * radius < kSmallestDiameter) {
    result.message = "a diameter below 18.6 m (61 ft) is too small for trigonometric regression";
    return result;
  }
  if (!tellsApart(data, kLeastOrder)) {
    result.message = "so little of the datum was seen that its waves cannot be told apart";
    return result;
  }
  const int order = chosenOrder(data, highestOrder(data, longest, kLeastOrder));
  result.message.clear();
  result.order = order;
  result.adjusted_r2 = adjustedR2(data, order);
  describe(stations, fitWaves(data, order), radius, result);
  result.rms = rmsLeft(stations);
  return result;
}

double longestGap(const std::vector<Station>& stations, double radius) {
  double first = kUnknown, last = kUnknown, longest = 0.0;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Missing) continue;
    if (std::isfinite(last)) longest = std::max(longest, s.azimuth - last);
    if (!std::isfinite(first)) first = s.azimuth;
    last = s.azimuth;
  }
  return radius * (std::isfinite(last) ? std::max(longest, first + kTwoPi - last) : kTwoPi);
}

}  // namespace tank_datum
