#include "shape/partial_ring_tilt.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "shape/datum_waves.h"
#include "tank_datum/shape/out_of_plane.h"

namespace tank_datum {
namespace {

constexpr int kLobes = 4;  // waves of more do not pass for a tilt along any arc that makes a tank
constexpr int kUnknowns = 3 + 2 * (kLobes - 1);

constexpr double kUnknownNoise = 1e-3;  // of levelled stations, to begin with [m]
constexpr double kLeastNoise = 1e-6;    // [m], or of a standard error

using Row = Eigen::Matrix<double, kUnknowns, 1>;
using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;

Row rowOf(const Station& station, const Eigen::Vector2d& center) {
  Row row;
  const double x = station.x - center.x(), y = station.y - center.y(), direction = std::atan2(y, x);
  row.head<3>() << 1.0, x, y;
  for (int n = 2; n <= kLobes; ++n) {
    row[2 * n - 1] = std::cos(n * direction);
    row[2 * n] = std::sin(n * direction);
  }
  return row;
}

}  // namespace

bool hasTiltingGap(const std::vector<Station>& stations) {
  constexpr double kHarmless = 30.0 * kPi / 180.0, kUsual = 2.5;  // in spacings of stations all round
  const auto measured = [](const Station& s) { return s.flag == StationFlag::Measured; };
  const auto count = static_cast<double>(std::count_if(stations.begin(), stations.end(), measured));
  return longestGap(stations, 1.0) > std::max(kHarmless, kUsual * kTwoPi / count);
}

PlaneFit fitPlaneBesideWaves(const std::vector<Station>& stations, const Eigen::Vector2d& center) {
  constexpr double kTwoLobes = 1.0 / 2000.0;  // amplitude over the radius
  const WaveData data = waveData(stations, kLobes);
  Square normal = Square::Zero();
  Row rhs = Row::Zero();
  std::vector<Row> rows;
  double squares = 0.0;
  for (const Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    const double weight = data.weights[rows.size()];
    rows.push_back(rowOf(s, center));
    normal += weight * rows.back() * rows.back().transpose();
    rhs += weight * s.z * rows.back();
    squares += rows.back().segment<2>(1).squaredNorm();
  }
  const double radius = std::sqrt(squares / static_cast<double>(rows.size()));
  Square belief = Square::Zero();
  for (int n = 2; n <= kLobes; ++n) {
    const double amplitude = kTwoLobes * radius * 4.0 / (n * n);
    belief(2 * n - 1, 2 * n - 1) = belief(2 * n, 2 * n) = 1.0 / (amplitude * amplitude);
  }
  PlaneFit fit;
  double noise = data.sigmas.empty() ? kUnknownNoise * kUnknownNoise : 1.0;
  for (int iteration = 0; iteration < 3; ++iteration) {
    const Eigen::FullPivLU<Square> solver(normal / noise + belief);
    const Row solution = solver.solve(rhs / noise);
    fit = {solution.head<3>(), solver.inverse().topLeftCorner<3, 3>()};
    std::vector<double> residuals;
    for (std::size_t i = 0; i < rows.size(); ++i) residuals.push_back(data.z[i] - rows[i].dot(solution));
    noise = std::max(noiseFactor(data, residuals, kLobes), kLeastNoise * kLeastNoise);
  }
  return fit;
}

}  // namespace tank_datum
