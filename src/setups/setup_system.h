#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "setups/setup_adjustment.h"

namespace tank_datum {

/// Parameters of one kind have one prior sigma: heights, tilts, places.
constexpr std::size_t kParameterKinds = 3;
using KindSigmas = std::array<double, kParameterKinds>;
inline std::size_t kindOf(Eigen::Index parameter) {
  const Eigen::Index own = parameter % SetupMotion::kParameters;
  return own == 0 ? 0 : own < 3 ? 1 : 2;
}

/// The overlaps as normal equations of the setups' parameters.
struct SetupSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

/// The parameters and their covariance under priors.
struct SetupSolution {
  Eigen::VectorXd errors;
  Eigen::MatrixXd covariance;
  KindSigmas determined{};  ///< of each kind the number of parameters that the overlaps tell
};

/// @param sigmas  one per parameter
SetupSolution solveSetups(const SetupSystem& system, const Eigen::VectorXd& sigmas);

/// One prior sigma per parameter; those of freed setups are so wide that the overlaps alone tell them.
Eigen::VectorXd priorSigmas(const KindSigmas& kinds, const std::vector<bool>& freed);

/// Of each kind the sum of the squares of the errors, without those of freed setups, and how many parameters they tell.
struct ErrorsByKind {
  KindSigmas squares{}, determined{};
};
ErrorsByKind errorsByKind(const SetupSolution& solution, const Eigen::VectorXd& priors, const std::vector<bool>& freed);

/// The variance components of a system.
/// @param start  for the fixed point, and the middle of the weak prior
/// @param held   kinds whose sigma is not to change
KindSigmas estimateSigmas(const SetupSystem& system, const KindSigmas& start,
                          const std::array<bool, kParameterKinds>& held, const std::vector<bool>& freed);

/// The usual sigma where few parameters or none tell another: wider by what one that is worth three parameters is
/// uncertain itself (Student), and where their errors are larger, by these together with the three.
/// @param squares  sum of those of the errors
/// @param known    how many parameters they tell
double assumedSigma(double usual, double squares = 0.0, double known = 0.0);

constexpr double kFarBetter = 0.25;  ///< of a usual sigma: a registration of another kind

/// A sigma estimated from few parameters. One below the usual sigma is drawn up towards it on the logarithm's scale, as
/// if that came from three parameters; but not where the setups agree far better than usual, as scans that one
/// adjustment has fitted to each other do. Wider by what a variance from few parameters is uncertain itself (Student).
/// @param known   how many parameters it comes from
/// @param others  the same setups' other sigma, over what is usual of it: where their tilts are as usual, no adjustment
///                has fitted them, and heights that seem to be fitted are chance
double temperedSigma(double sigma, double known, double usual, double others = 0.0);

}  // namespace tank_datum
