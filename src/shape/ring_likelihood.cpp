#include "shape/ring_likelihood.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kLeastVariance = 1e-18;  ///< of a coefficient [m^2]: a nanometre
using Numbers = std::array<double, 4>;    ///< ln amplitude, power, ln neighbours, ln length

RingPriors priorsOf(const Numbers& x, bool neighbours) {
  return {std::exp(x[0]), x[1], neighbours ? std::exp(x[2]) : 0.0, std::exp(x[3])};
}

/// -2 ln of the restricted likelihood, less what does not depend on the priors.
double misfit(const RingSums& sums, const RingPriors& priors) {
  const Eigen::Index waves = 2 * sums.order + 1;
  Eigen::MatrixXd precision = sums.normal / sums.scale2;
  const Eigen::VectorXd variances = waveVariances(priors, sums.order) + errorVariances(priors, sums.order);
  double log_variances = 0.0;
  for (Eigen::Index j = 3; j < waves; ++j) {
    const double v = std::max(variances[j], kLeastVariance);
    precision(j, j) += 1.0 / v;
    log_variances += std::log(v);
  }
  for (Eigen::Index j = waves; j < precision.rows(); ++j) precision(j, j) += 1.0;
  const Eigen::LLT<Eigen::MatrixXd> llt(precision);
  if (llt.info() != Eigen::Success) return 1e300;
  const Eigen::VectorXd half = llt.matrixL().solve(sums.rhs / sums.scale2);
  double log_determinant = 0.0;
  for (Eigen::Index j = 0; j < precision.rows(); ++j) log_determinant += 2.0 * std::log(llt.matrixL()(j, j));
  return log_variances + log_determinant - half.squaredNorm();
}

/// What is known of the numbers beforehand, as -2 ln of a density: waves of foundations fall with about the square of
/// their number; neighbours share errors over some degrees.
double belief(const Numbers& x) {
  constexpr double kUsualPower = 2.0, kPowers = 0.75;
  constexpr double kUsualLength = 8.0 * kPi / 180.0, kLengths = 0.8;
  return std::pow((x[1] - kUsualPower) / kPowers, 2.0) + std::pow((x[3] - std::log(kUsualLength)) / kLengths, 2.0);
}

}  // namespace

Eigen::VectorXd waveVariances(const RingPriors& priors, int order) {
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(2 * order + 1);
  for (int n = 2; n <= order; ++n) {
    const double deviation = priors.amplitude * std::pow(2.0 / n, priors.power);
    variances[2 * n - 1] = variances[2 * n] = deviation * deviation;
  }
  return variances;
}

Eigen::VectorXd errorVariances(const RingPriors& priors, int order) {
  constexpr int kAll = 400;  // waves that the error's variance is spread over
  const auto density = [&](int n) { return std::pow(3.0 / (priors.length * priors.length) + n * n, -2.0); };
  double sum = density(0);
  for (int n = 1; n <= kAll; ++n) sum += 2.0 * density(n);
  const double unit = priors.neighbours * priors.neighbours / sum;
  Eigen::VectorXd variances(2 * order + 1);
  variances[0] = unit * density(0);
  for (int n = 1; n <= order; ++n) variances[2 * n - 1] = variances[2 * n] = 2.0 * unit * density(n);
  return variances;
}

RingPriors likeliestPriors(const RingSums& sums, double sigma, std::optional<double> neighbours) {
  const double shared = std::max(0.02 * sigma, neighbours.value_or(0.0));
  const Numbers least = {std::log(1e-3 * sigma), 0.5, std::log(shared), std::log(2.0 * kPi / 180.0)};
  const Numbers most = {std::log(1e5 * sigma), 4.0, std::log(50.0 * sigma), std::log(30.0 * kPi / 180.0)};
  const auto value = [&](const Numbers& x) { return misfit(sums, priorsOf(x, neighbours.has_value())) + belief(x); };
  Numbers best{};
  double lowest = 1e301;
  for (const double length : {4.0, 15.0}) {
    Numbers x = {std::log(3.0 * sigma), 2.0, std::log(std::max(shared, 0.3 * sigma)), std::log(length * kPi / 180.0)};
    double here = value(x);
    Numbers step = {1.0, 0.5, 0.8, 0.5};
    for (int round = 0; round < 40 && *std::max_element(step.begin(), step.end()) > 0.1; ++round) {
      for (std::size_t k = 0; k < (neighbours ? 4U : 2U); ++k) {  // a pattern search, one number after the other
        bool moved = false;
        for (const double sign : {1.0, -1.0}) {
          Numbers there = x;
          there[k] = std::clamp(x[k] + sign * step[k], least[k], most[k]);
          const double then = there[k] == x[k] ? here : value(there);
          if (!(then < here)) continue;
          x = there, here = then, moved = true;
          break;
        }
        step[k] *= moved ? 1.3 : 0.5;
      }
    }
    if (here < lowest) lowest = here, best = x;
    if (!neighbours) break;
  }
  return priorsOf(best, neighbours.has_value());
}

}  // namespace tank_datum
