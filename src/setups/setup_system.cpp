#include "setups/setup_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum {

SetupSolution solveSetups(const SetupSystem& system, const Eigen::VectorXd& sigmas) {
  const Eigen::Index size = sigmas.size();
  // scaled by the sigmas, so that those near zero divide nothing
  Eigen::MatrixXd scaled = sigmas.asDiagonal() * system.matrix * sigmas.asDiagonal();
  scaled.diagonal().array() += 1.0;
  const Eigen::MatrixXd inverse = scaled.llt().solve(Eigen::MatrixXd::Identity(size, size));
  SetupSolution solution;
  solution.covariance = sigmas.asDiagonal() * inverse * sigmas.asDiagonal();
  solution.errors = sigmas.asDiagonal() * (inverse * (sigmas.asDiagonal() * system.right));
  for (Eigen::Index i = 0; i < size; ++i) solution.determined[kindOf(i)] += 1.0 - inverse(i, i);
  return solution;
}

Eigen::VectorXd priorSigmas(const KindSigmas& kinds, const std::vector<bool>& freed) {
  constexpr double kFree = 100.0;  // times the sigma of the others: as good as no prior
  Eigen::VectorXd sigmas(static_cast<Eigen::Index>(freed.size()) * SetupMotion::kParameters);
  for (Eigen::Index i = 0; i < sigmas.size(); ++i) {
    const bool is_free = freed[static_cast<std::size_t>(i / SetupMotion::kParameters)];
    sigmas[i] = kinds[kindOf(i)] * (is_free ? kFree : 1.0);
  }
  return sigmas;
}

ErrorsByKind errorsByKind(const SetupSolution& solution, const Eigen::VectorXd& priors,
                          const std::vector<bool>& freed) {
  ErrorsByKind sums;
  for (Eigen::Index i = 0; i < priors.size(); ++i) {
    if (freed[static_cast<std::size_t>(i / SetupMotion::kParameters)]) continue;
    sums.squares[kindOf(i)] += square(solution.errors[i]);
    sums.determined[kindOf(i)] += 1.0 - solution.covariance(i, i) / square(priors[i]);
  }
  return sums;
}

KindSigmas estimateSigmas(const SetupSystem& system, const KindSigmas& start,
                          const std::array<bool, kParameterKinds>& held, const std::vector<bool>& freed) {
  constexpr int kIterations = 200;
  constexpr double kSame = 0.002;       // relative change at which the fixed point is reached
  constexpr double kSpread = 3.0;       // of the weak prior on the logarithm of a sigma
  constexpr double kLargestStep = 4.0;  // factor of a variance
  KindSigmas sigmas = start;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Eigen::VectorXd priors = priorSigmas(sigmas, freed);
    const SetupSolution solution = solveSetups(system, priors);
    const auto [squares, determined] = errorsByKind(solution, priors, freed);
    double change = 0.0;
    for (std::size_t k = 0; k < kParameterKinds; ++k) {
      if (held[k]) continue;
      const double below = determined[k] + portable::log(sigmas[k] / start[k]) / (kSpread * kSpread);
      const double ratio = below > 0.0 ? squares[k] / (below * sigmas[k] * sigmas[k]) : kLargestStep;
      const double step = std::sqrt(std::clamp(ratio, 1.0 / kLargestStep, kLargestStep));
      change = std::max(change, std::abs(step - 1.0));
      sigmas[k] *= step;
    }
    if (change < kSame) break;
  }
  return sigmas;
}

namespace {
constexpr double kUsualWorth = 3.0;  // parameters
}

double assumedSigma(double usual, double squares, double known) {
  const double worth = kUsualWorth + known, seen = std::sqrt((kUsualWorth * square(usual) + squares) / worth);
  return std::max(usual * std::sqrt(1.0 + 2.0 / kUsualWorth), seen * std::sqrt(1.0 + 2.0 / worth));
}

double temperedSigma(double sigma, double known, double usual, double others) {
  const double ratio = std::max(sigma / (kFarBetter * usual), others);
  const double worth = sigma < usual ? kUsualWorth * ratio * ratio / (1.0 + ratio * ratio) : 0.0;
  const double drawn =
      worth > 0.0 ? portable::exp((known * portable::log(sigma) + worth * portable::log(usual)) / (known + worth))
                  : sigma;
  return drawn * std::sqrt(1.0 + 2.0 / (known + worth));
}

}  // namespace tank_datum
