#include "shell/shell_lean.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/portable_math.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "fit/ring_cells.h"
#include "shell/shell_bands.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

constexpr int kLeanOrder = 8;       // highest of the shell's lobes that may pass for a lean beside a gap
constexpr Eigen::Index kLobes = 3;  // the first coefficient of lobes

/// What a coefficient's variance is, over that of the second harmonic's: lobes of a shell fall off with their number.
double usualOf(Eigen::Index coefficient) {
  const double n = static_cast<double>((coefficient + 1) / 2);
  return 8.0 / (n * n * n);
}

/// The slopes' mean, lean and lobes, where lobes are drawn to zero as far as their own size says.
struct LeanFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
};

/// The size of the lobes and the scatter about them are found along with them (expectation maximisation).
/// @param worth  of the slopes; together, how many independent ones they are
LeanFit fitLean(const Eigen::MatrixXd& rows, const Eigen::VectorXd& slopes, const Eigen::VectorXd& worth) {
  constexpr int kSteps = 50;
  constexpr double kNone = 1e-12;  // of lobes and of scatter, squared [m2/m2]
  const Eigen::Index unknowns = rows.cols();
  const Eigen::MatrixXd normal = rows.transpose() * worth.asDiagonal() * rows;
  const Eigen::VectorXd rhs = rows.transpose() * worth.asDiagonal() * slopes;
  const double mean = worth.dot(slopes) / worth.sum();
  double lobes = kNone + worth.dot((slopes.array() - mean).square().matrix()) / worth.sum(), scatter = lobes;
  LeanFit fit;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::MatrixXd information = normal / scatter;
    for (Eigen::Index k = kLobes; k < unknowns; ++k) information(k, k) += 1.0 / (lobes * usualOf(k));
    fit.covariance = information.ldlt().solve(Eigen::MatrixXd::Identity(unknowns, unknowns));
    fit.coefficients = fit.covariance * rhs / scatter;
    double size = 0.0;
    for (Eigen::Index k = kLobes; k < unknowns; ++k)
      size += (square(fit.coefficients[k]) + fit.covariance(k, k)) / usualOf(k);
    lobes = kNone + size / static_cast<double>(unknowns - kLobes);
    const double left = worth.dot((slopes - rows * fit.coefficients).array().square().matrix());
    scatter = kNone + (left + (normal * fit.covariance).trace()) / worth.sum();
  }
  return fit;
}

/// What the slopes are worth: together those within ten degrees, over which lobes are alike, as one, and those over
/// more height more, as shapes and not noise are what a slope is off by.
Eigen::VectorXd worthOf(const std::vector<Plumbness>& plumbness) {
  constexpr std::size_t kArcs = 36;
  const auto arc_of = [](const Plumbness& p) { return ringCell(p.direction, kArcs); };
  std::array<double, kArcs> stations{};
  double squares = 0.0;
  for (const Plumbness& p : plumbness) ++stations[arc_of(p)], squares += square(p.height);
  Eigen::VectorXd worth(static_cast<Eigen::Index>(plumbness.size()));
  for (std::size_t i = 0; i < plumbness.size(); ++i) {
    const double usual = square(plumbness[i].height) * static_cast<double>(plumbness.size()) / squares;
    worth[static_cast<Eigen::Index>(i)] = usual / stations[arc_of(plumbness[i])];
  }
  return worth;
}

}  // namespace

Lean leanOf(const std::vector<Plumbness>& plumbness, const StationOptions& options) {
  constexpr std::size_t kFewestStations = 8;
  Lean lean;
  if (plumbness.size() < kFewestStations) return lean;
  const auto count = static_cast<Eigen::Index>(plumbness.size());
  Eigen::VectorXd directions(count), slopes(count);
  double height = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Plumbness& p = plumbness[static_cast<std::size_t>(i)];
    directions[i] = p.direction, slopes[i] = p.slope;
    height = std::max(height, p.height);
  }
  const LeanFit fit = fitLean(harmonicRows(directions, kLeanOrder), slopes, worthOf(plumbness));
  lean.gradient = fit.coefficients.segment<2>(1);
  lean.sigma = std::sqrt(std::max(fit.covariance(1, 1), fit.covariance(2, 2)));
  if (!(2.0 * lean.sigma <= kSteepestShell)) return {};
  lean.direction = azimuthOf(portable::atan2(lean.gradient.y(), lean.gradient.x()), options);
  lean.height = height;
  return lean;
}

}  // namespace tank_datum
