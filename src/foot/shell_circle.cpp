#include "foot/shell_circle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

constexpr int kUnknowns = 6;  // radius, centre x and y, lean x and y, and what the radius grows by with height
using Row = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// Lines this many standard deviations off are no shell; the lobes of one out of round are within three, and count
// fully.
constexpr double kStray = 6.0;

// The shell of a tank leans by less than one in a hundred, and widens by less where it bulges; on a short arc that and
// the circle can hardly be told apart.
constexpr double kLean = 0.01;

constexpr double kAlike = 10.0 * kDegree;  // over which a shell's lobes, and the cells' errors, are alike

/// What a shell is out of round by, usually: a fraction of its radius (root mean square). API 650, 7.5.3, allows 13 mm
/// of 6 m and 32 mm of 40 m at the foot.
constexpr double kOutOfRound = 3e-4;

/// The lines' radii at two heights as observations of the circle and its lean.
struct Observations {
  std::vector<Row> rows;
  std::vector<double> azimuths, radii;  ///< [rad], less that of the circle they are measured from [m]
  std::vector<double> weights;          ///< to begin with
  std::vector<std::size_t> lines;       ///< of which each is
};

/// A radius that was observed, and what the circle's moves by with it.
struct Gain {
  double azimuth, gain;
};

/// What the lobes of a shell, of two waves round it and more, make the radius of a circle err by that goes through a
/// part of it: standard deviation, of the root mean square of the lobes. Nothing of a circle through all of it.
double sharedWithLobes(const std::vector<Gain>& gains) {
  constexpr int kWaves = 12;
  double share = 0.0, all = 0.0;
  for (int n = 2; n <= kWaves; ++n) {
    const double usual = 1.0 / (n * n * n);  // variance of lobes: the longer, the larger
    double c = 0.0, s = 0.0;
    for (const Gain& g : gains) {
      c += g.gain * portable::cos(n * g.azimuth);
      s += g.gain * portable::sin(n * g.azimuth);
    }
    share += usual * (c * c + s * s);
    all += usual;
  }
  return std::sqrt(share / all);
}

/// The gains of a circle that is fitted to stations a degree apart, over an arc [rad].
std::vector<Gain> gainsOver(double arc) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d> rows;
  for (int i = 0; i < static_cast<int>(arc / kDegree + 0.5); ++i) {
    rows.push_back({1.0, portable::cos(i * kDegree), portable::sin(i * kDegree)});
    normal += rows.back() * rows.back().transpose();
  }
  const Eigen::Vector3d of_radius = normal.inverse().col(0);
  std::vector<Gain> gains;
  for (std::size_t i = 0; i < rows.size(); ++i)
    gains.push_back({static_cast<double>(i) * kDegree, of_radius.dot(rows[i])});
  return gains;
}

Observations observationsOf(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths,
                            const ShellHeights& heights, double radius, const std::vector<bool>& sure) {
  Observations all;
  std::size_t seen = 0, known = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    seen += lines[i].seen() ? 1 : 0;
    known += lines[i].seen() && sure[i] ? 1 : 0;
  }
  const bool begin_with_sure = 2 * known > seen;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].seen()) continue;
    const double c = portable::cos(azimuths[i]), s = portable::sin(azimuths[i]);
    for (const double h : {heights.from, heights.to}) {
      const double at = h > lines[i].straight_to ? 0.0 : h;
      all.azimuths.push_back(azimuths[i]);
      all.rows.push_back((Row() << 1.0, c, s, at * c, at * s, at).finished());
      all.radii.push_back(lines[i].at(0.0, at) - radius);
      all.lines.push_back(i);
      all.weights.push_back(begin_with_sure && !sure[i] ? 0.0 : 1.0);
    }
  }
  return all;
}

/// What a shell is seen to be off its circle by as neighbours are together, which noise is not: root mean square [m].
double seenOutOfRound(const std::vector<double>& azimuths, const std::vector<double>& off,
                      const std::vector<double>& weights) {
  std::array<double, static_cast<std::size_t>(kTwoPi / kAlike + 0.5)> sums{}, counts{};
  for (std::size_t i = 0; i < off.size(); ++i) {
    const std::size_t part = ringCell(azimuths[i], sums.size());
    sums[part] += weights[i] * off[i];
    counts[part] += weights[i];
  }
  double squares = 0.0, parts = 0.0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (counts[k] > 0.0) squares += square(sums[k] / counts[k]), parts += 1.0;
  }
  return std::sqrt(squares / std::max(1.0, parts));
}

/// Adds what is known of the unknowns beforehand.
/// @param sigma  of one observation
void addPrior(const CirclePrior& prior, double sigma, Normal& normal) {
  const std::array<double, kUnknowns> known{
      prior.sigma_radius, prior.sigma_center, prior.sigma_center, kLean, kLean, kLean};
  for (int j = 0; j < kUnknowns; ++j) {
    const double ratio = sigma / known[static_cast<std::size_t>(j)];
    normal(j, j) += 2.0 * ratio * ratio;  // a line's two heights are one observation
  }
}

}  // namespace

CirclePrior priorOf(const Tank& tank) {
  if (tank.coverage < kPi || !(tank.rms > 0.0)) return {};
  const double sigma = tank.rms / std::sqrt(tank.coverage / kAlike);
  const double lobes = kOutOfRound * tank.circle.radius * sharedWithLobes(gainsOver(tank.coverage));
  const double bulge = kOutOfRound * tank.circle.radius;  // of the wall farther up, all round
  return {std::hypot(sigma, lobes, bulge), std::hypot(sigma, 0.5 * kLean * tank.height)};
}

ShellCircle fitShellCircle(const std::vector<ShellLine>& lines, const std::vector<double>& azimuths,
                           const ShellHeights& heights, const Circle& start, const CirclePrior& prior,
                           const std::vector<bool>& sure) {
  const auto [rows, azimuths_of, radii, weights_of, lines_of] =
      observationsOf(lines, azimuths, heights, start.radius, sure);
  ShellCircle result;
  result.circle = start;
  if (rows.size() < 10) return result;
  std::vector<double> weights = weights_of, left = radii;
  Row solution = Row::Zero(), of_radius = Row::Zero();
  const auto sigmaOf = [](const std::vector<double>& off) { return std::max(robustSigma(off, median(off)), 1e-7); };
  double sigma = sigmaOf(left);
  for (int iteration = 0; iteration < 20; ++iteration) {
    Normal normal = Normal::Zero();
    Row rhs = Row::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      normal += weights[i] * rows[i] * rows[i].transpose();
      rhs += weights[i] * radii[i] * rows[i];
    }
    addPrior(prior, sigma, normal);
    const Normal inverse = normal.inverse();
    solution = inverse * rhs;
    of_radius = inverse.row(0);
    for (std::size_t i = 0; i < rows.size(); ++i) left[i] = radii[i] - rows[i].dot(solution);
    sigma = sigmaOf(left);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      weights[i] = std::abs(left[i]) < kStray * sigma ? 1.0 : 0.0;
    }
  }
  std::vector<Gain> gains;
  for (std::size_t i = 0; i < rows.size(); ++i) gains.push_back({azimuths_of[i], weights[i] * of_radius.dot(rows[i])});
  const double out_of_round = std::hypot(kOutOfRound * start.radius, seenOutOfRound(azimuths_of, left, weights));
  const double lobes = out_of_round * sharedWithLobes(gains);
  result.sigma_radius = std::hypot(sigma * std::sqrt(2.0 * of_radius[0]), lobes);
  result.strays.assign(lines.size(), false);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (weights[i] == 0.0) result.strays[lines_of[i]] = true;
  }
  result.circle = {start.center + solution.segment<2>(1), start.radius + solution[0]};
  return result;
}

}  // namespace tank_datum
