#include "foot/shell_circle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

using Row = Eigen::Matrix<double, 5, 1>;  // radius, centre x and y, lean x and y
using Normal = Eigen::Matrix<double, 5, 5>;

// Lines this many standard deviations off are no shell; the lobes of one out of round are within three, and count
// fully.
constexpr double kStray = 6.0;

// The shell of a tank leans by less than one in a hundred; on a short arc lean and centre can hardly be told apart.
constexpr double kLean = 0.01;

/// The lines' radii at two heights as observations of the circle and its lean.
struct Observations {
  std::vector<Row> rows;
  std::vector<double> radii;  ///< less that of the circle they are measured from [m]
};

Observations observationsOf(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths,
                            const ShellHeights& heights, double radius) {
  Observations all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].seen()) continue;
    const double c = portable::cos(azimuths[i]), s = portable::sin(azimuths[i]);
    for (const double h : {heights.from, heights.to}) {
      const double at = h > lines[i].straight_to ? 0.0 : h;
      all.rows.push_back((Row() << 1.0, c, s, at * c, at * s).finished());
      all.radii.push_back(lines[i].at(0.0, at) - radius);
    }
  }
  return all;
}

/// Adds what is known of the unknowns beforehand.
/// @param sigma  of one observation
void addPrior(const CirclePrior& prior, double sigma, Normal& normal) {
  const std::array<double, 5> known{prior.sigma_radius, prior.sigma_center, prior.sigma_center, kLean, kLean};
  for (int j = 0; j < 5; ++j) {
    const double ratio = sigma / known[static_cast<std::size_t>(j)];
    normal(j, j) += 2.0 * ratio * ratio;  // a line's two heights are one observation
  }
}

}  // namespace

CirclePrior priorOf(const Tank& tank) {
  constexpr double kAlike = 10.0 * kPi / 180.0;  // a shell's lobes and the cells' errors are alike over ten degrees
  if (tank.coverage < kPi || !(tank.rms > 0.0)) return {};
  const double sigma = tank.rms / std::sqrt(tank.coverage / kAlike);
  return {sigma, std::hypot(sigma, 0.5 * kLean * tank.height)};
}

ShellCircle fitShellCircle(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths,
                           const ShellHeights& heights, const Circle& start, const CirclePrior& prior) {
  const auto [rows, radii] = observationsOf(lines, azimuths, heights, start.radius);
  ShellCircle result;
  result.circle = start;
  if (rows.size() < 10) return result;
  std::vector<double> weights(rows.size(), 1.0), left = radii;
  Row solution = Row::Zero();
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double sigma = std::max(robustSigma(left, median(left)), 1e-7);
    Normal normal = Normal::Zero();
    Row rhs = Row::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      normal += weights[i] * rows[i] * rows[i].transpose();
      rhs += weights[i] * radii[i] * rows[i];
    }
    addPrior(prior, sigma, normal);
    const Normal inverse = normal.inverse();
    solution = inverse * rhs;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      left[i] = radii[i] - rows[i].dot(solution);
      weights[i] = std::abs(left[i]) < kStray * sigma ? 1.0 : 0.0;
    }
    result.sigma_radius = sigma * std::sqrt(2.0 * inverse(0, 0));
  }
  result.circle = {start.center + solution.segment<2>(1), start.radius + solution[0]};
  return result;
}

}  // namespace tank_datum
