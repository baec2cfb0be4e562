#include <algorithm>
#include <cmath>

#include "core/deviates.h"
#include "shape/ring_model.h"

namespace tank_datum {
namespace {

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index draws, Deviates& normal) {
  Eigen::MatrixXd m(rows, draws);
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) m(i, j) = normal();
  }
  return m;
}

/// Of each draw what makes its deviates those of Student's t, where the scale is from residuals.
/// @param given  degrees of freedom; 0: the scale is known
Eigen::VectorXd widthsOf(double given, Eigen::Index draws, Deviates& normal) {
  Eigen::VectorXd widths = Eigen::VectorXd::Ones(draws);
  for (Eigen::Index j = 0; j < widths.size() && given > 0.0; ++j) {
    double squares = 0.0;
    const int freedom = std::min(200, static_cast<int>(std::lround(given)));
    for (int k = 0; k < freedom; ++k) squares += std::pow(normal(), 2.0);
    widths[j] = std::sqrt(freedom / squares);
  }
  return widths;
}

/// A root of the covariance of a survey's sums of waves.
Eigen::MatrixXd rootOf(Eigen::MatrixXd sums_covariance) {
  constexpr double kRidge = 1e-8;  // a gap leaves some sums of waves without any station: their errors are nil
  sums_covariance.diagonal() *= 1.0 + kRidge;
  return sums_covariance.llt().matrixL();
}

}  // namespace

RingModel::Simulated RingModel::simulate(int draws, std::uint64_t seed) const {
  Deviates normal(seed);
  const auto draw = [&](Eigen::Index rows) { return drawn(rows, draws, normal); };
  const Eigen::Index waves = 2 * order_ + 1, all = normal_.rows();
  const Eigen::VectorXd widths = widthsOf(noise_.freedom, draws, normal);
  Simulated result;
  const Eigen::MatrixXd unit = draw(all);
  const Eigen::MatrixXd spread = posterior_.matrixU().solve(unit) * widths.asDiagonal();
  result.truth = spread.topRows(waves);
  Eigen::VectorXd shares = Eigen::VectorXd::Ones(waves), own = errors_.cwiseSqrt();
  for (Eigen::Index j = 3; j < waves; ++j) {
    shares[j] = waves_[j] / (waves_[j] + errors_[j] + 1e-18);
    own[j] = std::sqrt(shares[j] * errors_[j]);
  }
  result.truth = shares.asDiagonal() * result.truth + own.asDiagonal() * draw(waves);
  result.truth.colwise() += mean_;

  // the same survey of that datum: its waves and fresh errors of neighbours, setups, and stations
  Eigen::MatrixXd seen(all, draws);
  seen.topRows(waves) = result.truth + errors_.cwiseSqrt().asDiagonal() * draw(waves);
  seen.row(0).array() -= offset_;
  seen.bottomRows(all - waves) = draw(all - waves);
  const double scale2 = noise_.scale * noise_.scale;
  Eigen::MatrixXd sums = product(normal_, seen) / scale2;  // of the survey, as the solution takes them
  if (dense()) {
    sums += product(rootOf(normal_), draw(all)) * widths.asDiagonal() / noise_.scale;
  } else {
    const Eigen::MatrixXd own_errors =
        (noise_.scale * data_.sigmas).asDiagonal() * draw(data_.count()) * widths.asDiagonal();
    result.survey = product(design_, seen) + own_errors;
    const Eigen::VectorXd weights = data_.sigmas.array().square().inverse();
    sums = product((weights.asDiagonal() * design_).transpose(), result.survey) / scale2;
    result.survey.array() += offset_;
  }
  result.estimate = posterior_.solve(sums).topRows(waves);
  result.estimate = shares.asDiagonal() * result.estimate;
  result.estimate.row(0).array() += offset_;
  return result;
}

}  // namespace tank_datum
