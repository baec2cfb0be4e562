#include "shape/ring_likelihood.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

using Numbers = std::array<double, 4>;  ///< ln amplitude, power, ln neighbours, ln length

RingPriors priorsOf(const Numbers& x, bool neighbours) {
  return {portable::exp(x[0]), x[1], neighbours ? portable::exp(x[2]) : 0.0, portable::exp(x[3])};
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
    log_variances += portable::log(v);
  }
  for (Eigen::Index j = waves; j < precision.rows(); ++j) precision(j, j) += 1.0;
  const Eigen::LLT<Eigen::MatrixXd> llt(precision);
  if (llt.info() != Eigen::Success) return 1e300;
  const Eigen::VectorXd half = llt.matrixL().solve(sums.rhs / sums.scale2);
  double log_determinant = 0.0;
  for (Eigen::Index j = 0; j < precision.rows(); ++j) log_determinant += 2.0 * portable::log(llt.matrixL()(j, j));
  return log_variances + log_determinant - half.squaredNorm();
}

/// What is known of the numbers beforehand, as -2 ln of a density: waves of foundations fall with about the square of
/// their number; neighbours share errors over some degrees.
double hyperpriorMisfit(const Numbers& x, double wave) {
  constexpr double kAmplitudes = 0.7, kUsualPower = 2.0, kPowers = 0.75;
  constexpr double kUsualLength = 8.0 * kPi / 180.0, kLengths = 0.8;
  return square((x[0] - portable::log(wave)) / kAmplitudes) + square((x[1] - kUsualPower) / kPowers) +
         square((x[3] - portable::log(kUsualLength)) / kLengths);
}

/// A pattern search, one number after the other.
template <typename Value>
Numbers lowest(Numbers x, const Numbers& least, const Numbers& most, std::size_t count, Value value) {
  constexpr double kFinest = 0.15;  // of a logarithm
  constexpr int kRounds = 25;
  Numbers step = {1.0, 0.5, 0.8, 0.5};
  double here = value(x);
  const auto coarsest = [&] { return *std::max_element(step.begin(), step.begin() + static_cast<int>(count)); };
  for (int round = 0; round < kRounds && coarsest() > kFinest; ++round) {
    for (std::size_t k = 0; k < count; ++k) {
      bool moved = false;
      for (const double sign : {1.0, -1.0}) {
        Numbers there = x;
        there[k] = std::clamp(x[k] + sign * step[k], least[k], most[k]);
        const double then = there[k] == x[k] ? here : value(there);
        if (!(then < here)) continue;
        x = there, here = then, moved = true;
        break;
      }
      step[k] *= moved ? 1.3 : 0.4;
    }
  }
  return x;
}

}  // namespace

Eigen::VectorXd waveVariances(const RingPriors& priors, int order) {
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(2 * order + 1);
  for (int n = 2; n <= order; ++n) {
    const double deviation = priors.amplitude * portable::pow(2.0 / n, priors.power);
    variances[2 * n - 1] = variances[2 * n] = deviation * deviation;
  }
  return variances;
}

Eigen::VectorXd errorVariances(const RingPriors& priors, int order) {
  constexpr int kAll = 400;  // waves that the error's variance is spread over
  const auto density = [&](int n) { return 1.0 / square(3.0 / (priors.length * priors.length) + n * n); };
  double sum = density(0);
  for (int n = 1; n <= kAll; ++n) sum += 2.0 * density(n);
  const double unit = priors.neighbours * priors.neighbours / sum;
  Eigen::VectorXd variances(2 * order + 1);
  variances[0] = unit * density(0);
  for (int n = 1; n <= order; ++n) variances[2 * n - 1] = variances[2 * n] = 2.0 * unit * density(n);
  return variances;
}

std::pair<RingPriors, double> likeliestPriors(const RingSums& sums, const RingHyperprior& hyperprior) {
  const bool neighbours = hyperprior.neighbours.has_value();
  const double sigma = hyperprior.sigma, shared = std::max(0.02 * sigma, hyperprior.neighbours.value_or(0.0));
  const Numbers least = {portable::log(1e-3 * sigma), 0.5, portable::log(shared), portable::log(2.0 * kPi / 180.0)};
  const Numbers most = {portable::log(1e5 * sigma), 4.0, portable::log(50.0 * sigma),
                        portable::log(30.0 * kPi / 180.0)};
  const auto value = [&](const Numbers& x) {
    return misfit(sums, priorsOf(x, neighbours)) + hyperpriorMisfit(x, hyperprior.wave);
  };
  Numbers start{};
  double before = 1e301;
  for (const double length : {4.0, 15.0}) {
    const Numbers x = {portable::log(3.0 * sigma), 2.0, portable::log(std::max(shared, 0.3 * sigma)),
                       portable::log(length * kPi / 180.0)};
    const double here = value(x);
    if (here < before) before = here, start = x;
  }
  const Numbers best = lowest(start, least, most, neighbours ? 4 : 2, value);
  return {priorsOf(best, neighbours), value(best)};
}

}  // namespace tank_datum
