#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>

namespace tank_datum {

constexpr double kLeastVariance = 1e-18;  ///< of a coefficient [m^2]: a nanometre

/// What the restricted likelihood of a ring's priors needs: sums over its stations, in units of their sigmas.
struct RingSums {
  const Eigen::MatrixXd& normal;
  const Eigen::VectorXd& rhs;
  double squares;
  Eigen::Index stations;
  int order;      ///< waves; unknowns after 2 order + 1 are local shapes and shared errors of variance 1
  double scale2;  ///< variance of the stations' own errors, over sigmas^2
};

/// Priors by a few numbers.
struct RingPriors {
  double amplitude = 0.0;   ///< standard deviation of a coefficient of the wave n = 2 [m]
  double power = 2.0;       ///< it falls with (2 / n)^power
  double neighbours = 0.0;  ///< standard deviation of the error that neighbours share [m]
  double length = 0.1;      ///< [rad]
};

/// Prior variance of each coefficient 1, a1, b1, ... [m^2]: of the waves (infinite for the first three: here 0), and of
/// what an error that neighbours share adds to it.
Eigen::VectorXd waveVariances(const RingPriors& priors, int order);
Eigen::VectorXd errorVariances(const RingPriors& priors, int order);

/// What is known before the stations are looked at.
struct RingHyperprior {
  double sigma = 0.0;                ///< usual error of a station [m]
  double wave = 0.0;                 ///< usual standard deviation of a coefficient of n = 2 [m]
  std::optional<double> neighbours;  ///< least standard deviation of the error that neighbours share [m]; nothing: none
};

/// Priors of the largest restricted marginal likelihood, times a wide prior of usual numbers.
/// @return them, and -2 ln of that likelihood, less what depends on the stations' own errors alone
std::pair<RingPriors, double> likeliestPriors(const RingSums& sums, const RingHyperprior& hyperprior);

}  // namespace tank_datum
