#include "shape/out_of_plane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/azimuth.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "limits/survey_spacing.h"
#include "shape/datum_waves.h"
#include "shape/partial_ring_tilt.h"
#include "shape/ring_fits.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

constexpr double kSmallestDiameter = 18.6;   // 61 ft [m]
constexpr std::size_t kFewestStations = 65;  // stations: "more than 64"
constexpr int kLeastOrder = 4;

/// 1 - (what an order leaves) / (what the plane leaves), each over its degrees of freedom, of orders 0 to `highest`.
std::vector<double> adjustedR2s(const WaveData& data, int highest) {
  const auto count = static_cast<Eigen::Index>(data.count());
  double sum = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < data.count(); ++i) sum += data.weights[i] * data.z[i], weight += data.weights[i];
  Eigen::MatrixXd rows(count, 2 * highest + 1);
  Eigen::VectorXd z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    rows.row(i) = std::sqrt(data.weights[at]) * harmonicRow(data.azimuths[at], highest);
    z[i] = std::sqrt(data.weights[at]) * (data.z[at] - sum / weight);
  }
  // columns in order of their waves: what each order leaves is the rest of z in the basis that they span
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  z.applyOnTheLeft(qr.householderQ().adjoint());
  const auto left = [&](int order) { return z.tail(count - 2 * order - 1).squaredNorm(); };
  const auto n = static_cast<double>(count);
  std::vector<double> all(static_cast<std::size_t>(highest) + 1);
  for (int k = 0; k <= highest; ++k) {
    all[static_cast<std::size_t>(k)] = 1.0 - left(k) / (n - 2.0 * k - 1.0) / (left(1) / (n - 3.0));
  }
  return all;
}

/// The highest order at which one more wave still raises the adjusted R2; all of them are tried.
int chosenOrder(const std::vector<double>& adjusted_r2) {
  const auto highest = static_cast<int>(adjusted_r2.size()) - 1;
  int order = std::min(kLeastOrder, highest);
  for (int k = order + 1; k <= highest; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (adjusted_r2[at] > adjusted_r2[at - 1]) order = k;
  }
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

/// Standard error of a fitted row: what the model leaves unknown of it, and how far the fit is from the model.
double sigmaOf(const Eigen::RowVectorXd& row, const PeriodicFit& fit, const PeriodicFit& model) {
  const double apart = row * (fit.coefficients - model.coefficients);
  return std::sqrt(std::max(0.0, row.dot(model.covariance * row.transpose())) + apart * apart);
}

/// The model's waves up to an order.
PeriodicFit modelled(const RingModel& model, const Eigen::MatrixXd& covariance, int order) {
  const Eigen::Index count = 2 * std::min(order, model.order()) + 1;
  PeriodicFit fit;
  fit.coefficients = model.coefficients().head(count);
  fit.covariance = covariance.topLeftCorner(count, count);
  return fit;
}

PeriodicFit padded(const PeriodicFit& fit, Eigen::Index count) {
  PeriodicFit longer = fit;
  longer.coefficients = Eigen::VectorXd::Zero(count);
  longer.coefficients.head(fit.coefficients.size()) = fit.coefficients;
  return longer;
}

/// The regression at every station whose u is known.
std::vector<StationBending> bendingOf(const std::vector<Station>& stations, const PeriodicFit& fitted,
                                      const PeriodicFit& model, double radius) {
  const PeriodicFit fit = padded(fitted, model.coefficients.size());
  std::vector<StationBending> bending(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[i];
    if (!std::isfinite(s.u)) continue;
    const Eigen::RowVectorXd bent = curvatureRow(s.azimuth, fit.order(), radius);
    bending[i].u_fit = fit(s.azimuth) - s.z_tilt;
    bending[i].sigma_u_fit = sigmaOf(bendingRow(s.azimuth, fit.order()), fit, model);
    bending[i].curvature = bent * fit.coefficients;
    bending[i].sigma_curvature = sigmaOf(bent, fit, model);
  }
  return bending;
}

void findLargestCurvature(const std::vector<Station>& stations, OutOfPlane& result) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const StationBending& here = result.stations[i];
    if (!std::isfinite(stations[i].u) || std::abs(here.curvature) <= result.max_curvature) continue;
    result.max_curvature = std::abs(here.curvature);
    result.sigma_curvature = here.sigma_curvature;
    result.max_curvature_azimuth = stations[i].azimuth;
  }
}

/// Why there is no regression of these; or empty.
std::string objection(const WaveData& data, double radius) {
  if (data.count() < kFewestStations)
    return std::to_string(data.count()) + " stations measured; trigonometric regression is for more than 64";
  if (2.0 * radius < kSmallestDiameter)
    return "a diameter below 18.6 m (61 ft) is too small for trigonometric regression";
  if (!tellsApart(data, kLeastOrder)) return "so little of the datum was seen that its waves cannot be told apart";
  return {};
}

double rmsLeft(const std::vector<Station>& stations, const std::vector<StationBending>& bending) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (stations[i].flag != StationFlag::Measured) continue;
    const double left = stations[i].u - bending[i].u_fit;
    sum += left * left;
    count += 1;
  }
  return std::sqrt(sum / count);
}

}  // namespace

int shortestWave(double radius) { return static_cast<int>(std::floor(kPi * radius / kSurveySpacing)); }

std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius) {
  const RingData data = ringData(stations, radius, {});
  return data.count() < 4 ? std::vector<Harmonic>() : harmonicsOf(stations, radius, RingModel(data));
}

std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius, const RingModel& model) {
  constexpr int kAlways = 6;
  const WaveData rough = waveData(stations, 1);
  const int order = std::min(highestOrder(rough, std::max(kAlways, shortestWave(radius)), kAlways), model.order());
  std::vector<Harmonic> harmonics;
  if (rough.count() < 4 || order < 1) return harmonics;
  PeriodicFit fit = modelled(model, model.covariance(), order);
  if (!hasTiltingGap(stations)) fit.coefficients = fitWaves(waveData(stations, order), order).coefficients;
  harmonics.push_back({0, fit.coefficients[0], kUnknown, std::sqrt(fit.covariance(0, 0))});
  for (int n = 1; n <= order; ++n) {
    const Eigen::Vector2d wave = fit.coefficients.segment<2>(2 * n - 1);
    const double amplitude = wave.norm(), phase = portable::atan2(wave.y(), wave.x());
    const Eigen::Vector2d along(portable::cos(phase), portable::sin(phase));
    const double variance = along.dot(fit.covariance.block<2, 2>(2 * n - 1, 2 * n - 1) * along);
    harmonics.push_back({n, amplitude, (phase < 0.0 ? phase + kTwoPi : phase) / n, std::sqrt(std::max(0.0, variance))});
  }
  return harmonics;
}

OutOfPlane fitOutOfPlane(const std::vector<Station>& stations, double radius) {
  const RingData data = ringData(stations, radius, {});
  return data.count() < 4 ? OutOfPlane() : fitOutOfPlane(stations, radius, RingModel(data));
}

OutOfPlane fitOutOfPlane(const std::vector<Station>& stations, double radius, const RingModel& model) {
  OutOfPlane result;
  for (const Station& s : stations) {
    if (!std::isfinite(s.u) || std::abs(s.u) <= result.max_u) continue;
    result.max_u = std::abs(s.u);
    result.max_u_azimuth = s.azimuth;
  }
  const int told = static_cast<int>(stations.size()) / 8;  // waves that so many stations tell apart, on any radius
  const int longest = std::clamp(shortestWave(radius), kLeastOrder, std::max(kLeastOrder, told));
  const WaveData data = waveData(stations, std::min(longest, told));
  if (!std::isfinite(result.max_u)) return result;
  result.message = objection(data, radius);
  if (!result.message.empty()) return result;
  const std::vector<double> adjusted_r2 = adjustedR2s(data, highestOrder(data, longest, kLeastOrder));
  const PeriodicFit waves = modelled(model, model.covariance(), longest);
  // beside a gap the regression's waves cannot be told apart as well as the model's, which knows how they fall
  const bool gap = hasTiltingGap(stations);
  result.order = gap ? waves.order() : chosenOrder(adjusted_r2);
  const auto compared = std::min(static_cast<std::size_t>(result.order), adjusted_r2.size() - 1);
  result.adjusted_r2 = adjusted_r2[compared];
  result.stations = bendingOf(stations, gap ? waves : fitWaves(data, result.order), waves, radius);
  findLargestCurvature(stations, result);
  result.rms = rmsLeft(stations, result.stations);
  return result;
}

double longestGap(const std::vector<Station>& stations, double radius) {
  std::vector<double> measured;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) measured.push_back(s.azimuth);
  }
  return radius * widestArc(std::move(measured));
}

}  // namespace tank_datum
