#include "shell/shell_roundness.h"

#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/adaptive_smooth.h"
#include "fit/circle.h"
#include "fit/harmonics.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kWidestGap = 120.0 * kPi / 180.0;  // of a circle that the rest still determines [rad]
constexpr int kOvalOrder = 8;  // harmonics that fill gaps; half as many tell how well they can be filled
constexpr std::size_t kFewestStations = 8;
constexpr double kWidestSmooth = 15.0;  // half the arc that extremes are smoothed over [deg]

/// The widest angle from a seen station to the next [rad].
double widestGap(const std::vector<ShellCell>& row) {
  std::size_t widest = 0, unseen = 0;
  for (std::size_t i = 0; i < 2 * row.size(); ++i) {
    unseen = row[i % row.size()].seen() ? 0 : unseen + 1;
    widest = std::max(widest, unseen);
  }
  return static_cast<double>(widest + 1) * kTwoPi / static_cast<double>(row.size());
}

std::size_t countSeen(const std::vector<ShellCell>& row) {
  return static_cast<std::size_t>(
      std::count_if(row.begin(), row.end(), [](const ShellCell& cell) { return cell.seen(); }));
}

/// Where the shell stands at a radius [m].
Eigen::Vector2d placeOf(const Circle& datum_circle, const Station& station, double radius) {
  return datum_circle.center +
         radius * Eigen::Vector2d(portable::cos(station.direction), portable::sin(station.direction));
}

/// How far the shell is off a circle at every station, NaN where it is not seen [m].
std::vector<double> deviationsFrom(const Circle& circle, const std::vector<ShellCell>& row,
                                   const std::vector<Station>& stations, const Circle& datum_circle) {
  std::vector<double> deviations(row.size(), kUnknown);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].seen()) deviations[i] = circle.residual(placeOf(datum_circle, stations[i], row[i].radius));
  }
  return deviations;
}

/// The circle of least squares through the shell all round. What is not seen is taken from the harmonics of the rest:
/// without them an oval seen in part would pass for a larger circle, and a wave behind a nozzle for a smaller one.
Circle circleThrough(const std::vector<ShellCell>& row, const std::vector<Station>& stations,
                     const Circle& datum_circle, int order) {
  constexpr double kQuiet = 1e-3;
  std::vector<double> directions, radii;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!row[i].seen()) continue;
    directions.push_back(stations[i].direction);
    radii.push_back(row[i].radius);
  }
  order = std::min(order, static_cast<int>(radii.size() / 3));
  const PeriodicFit shape = fitHarmonics(directions, radii, {}, {order, false, kQuiet});
  std::vector<Eigen::Vector2d> plan;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double radius = row[i].seen() ? row[i].radius : shape(stations[i].direction);
    plan.push_back(placeOf(datum_circle, stations[i], radius));
  }
  return fitCircle(plan, {}, datum_circle);
}

/// Returns the station of the larger one.
std::size_t findExtremes(const std::vector<ShellCell>& row, const std::vector<double>& deviations,
                         const std::vector<Station>& stations, Roundness& roundness) {
  std::vector<SeriesValue> series;
  for (std::size_t i = 0; i < row.size(); ++i) series.push_back({deviations[i], row[i].sigma, row[i].shared});
  const auto widest = static_cast<std::size_t>(kWidestSmooth / 360.0 * static_cast<double>(row.size()));
  series = smoothed(series, widest);
  double largest = -1.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double value = series[i].value;
    if (!std::isfinite(value)) continue;
    if (!(value <= roundness.max_deviation)) roundness.max_deviation = value;
    if (!(value >= roundness.min_deviation)) roundness.min_deviation = value;
    if (std::abs(value) <= largest) continue;
    largest = std::abs(value);
    worst = i;
  }
  roundness.azimuth = stations[worst].azimuth;
  roundness.sigma = series[worst].sigma;
  return worst;
}

/// How far what may be the shell lies off a circle, at most: a dent beside something that hides the rest of it, or
/// between coarse stations. What is farther off stands before the shell.
double doubtedOf(const Circle& circle, const std::vector<ShellCell>& row, const std::vector<Station>& stations,
                 const Circle& datum_circle) {
  constexpr double kDeepest = 0.1;  // of a dent [m]
  double largest = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!std::isfinite(row[i].doubted)) continue;
    const double off = std::abs(circle.residual(placeOf(datum_circle, stations[i], row[i].doubted)));
    if (off <= kDeepest) largest = std::max(largest, off);
  }
  return largest;
}

}  // namespace

Roundness arcOf(const std::vector<ShellCell>& row, double height, const std::vector<Station>& stations,
                const Circle& datum_circle, const Circle& expected) {
  Roundness arc;
  arc.height = height;
  arc.stations = countSeen(row);
  if (arc.stations < kFewestStations) return arc;
  const std::vector<double> deviations = deviationsFrom(expected, row, stations, datum_circle);
  arc.widest_gap = widestGap(row) * datum_circle.radius;
  arc.circle = expected;
  arc.doubted = doubtedOf(expected, row, stations, datum_circle);
  findExtremes(row, deviations, stations, arc);
  arc.sigma = std::hypot(arc.sigma, median(finiteOf(deviations)));
  return arc;
}

bool isAtFoot(double height) { return height <= 0.305; }

Roundness roundnessOf(const std::vector<ShellCell>& row, double height, const std::vector<Station>& stations,
                      const Circle& datum_circle, std::vector<double>& deviations) {
  Roundness roundness;
  roundness.height = height;
  deviations.assign(row.size(), kUnknown);
  roundness.stations = countSeen(row);
  const double gap = widestGap(row);
  if (roundness.stations < kFewestStations || 2 * roundness.stations < row.size() || gap > kWidestGap) return roundness;
  roundness.widest_gap = gap * datum_circle.radius;
  const Circle circle = circleThrough(row, stations, datum_circle, kOvalOrder);
  const Circle plainer = circleThrough(row, stations, datum_circle, kOvalOrder / 2);
  if (!circle.valid() || !plainer.valid()) return roundness;
  roundness.circle = circle;
  roundness.doubted = doubtedOf(circle, row, stations, datum_circle);
  deviations = deviationsFrom(circle, row, stations, datum_circle);
  const std::size_t worst = findExtremes(row, deviations, stations, roundness);
  const Eigen::Vector2d place = placeOf(datum_circle, stations[worst], row[worst].radius);
  roundness.sigma = std::hypot(roundness.sigma, circle.residual(place) - plainer.residual(place));
  return roundness;
}

}  // namespace tank_datum
