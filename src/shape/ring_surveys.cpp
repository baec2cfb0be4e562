#include <algorithm>
#include <cmath>

#include "core/deviates.h"
#include "fit/harmonics.h"
#include "shape/ring_model.h"

namespace tank_datum {
namespace {

Eigen::MatrixXd drawn(Deviates& normal, Eigen::Index rows, int draws) {
  Eigen::MatrixXd m(rows, draws);
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) m(i, j) = normal();
  }
  return m;
}

/// A width for each draw.
Eigen::VectorXd drawnWidths(Deviates& normal, double freedom, int draws) {
  Eigen::VectorXd widths(draws);
  for (double& width : widths) width = studentWidth(normal, freedom);
  return widths;
}

}  // namespace

/// Of each unknown of the datum, what part of the survey's is the datum's and not an error that neighbours share.
Eigen::VectorXd RingModel::datumShares() const {
  Eigen::VectorXd shares = Eigen::VectorXd::Ones(datumCount());
  for (Eigen::Index j = 3; j < waveCount(); ++j) shares[j] = waves_[j] / (waves_[j] + errors_[j] + kLeastVariance);
  return shares;
}

/// From unknowns as they are solved for, waves beside local shapes over their scales, to coefficients().
Eigen::MatrixXd RingModel::withWavesOfShapes(Eigen::MatrixXd solved) const {
  for (std::size_t k = 0; k < shapes_.size(); ++k) {
    const Eigen::Index row = waveCount() + static_cast<Eigen::Index>(k);
    solved.row(row) *= shapes_[k].scale;
    solved.topRows(waveCount()) += product(shapes_[k].waves(order_), solved.row(row));
  }
  return solved;
}

Eigen::VectorXd RingModel::coefficients() const {
  if (order_ == 0) return solution_;
  Eigen::VectorXd datum = datumShares().cwiseProduct(solution_.head(datumCount()));
  datum.head<3>() += plane_;
  return withWavesOfShapes(datum);
}

Eigen::MatrixXd RingModel::solvedCovariance() const {
  const Eigen::Index all = normal_.rows(), datum = datumCount();
  const Eigen::MatrixXd inverse = posterior_.solve(Eigen::MatrixXd::Identity(all, all));
  const Eigen::VectorXd shares = datumShares();
  Eigen::MatrixXd covariance = shares.asDiagonal() * inverse.topLeftCorner(datum, datum) * shares.asDiagonal();
  Eigen::VectorXd own = Eigen::VectorXd::Zero(datum);
  own.head(waveCount()) = shares.head(waveCount()).cwiseProduct(errors_);
  covariance.diagonal() += own;
  return covariance;
}

Eigen::MatrixXd RingModel::covariance() const {
  if (order_ == 0) return Eigen::MatrixXd::Zero(1, 1);
  const Eigen::MatrixXd half = withWavesOfShapes(solvedCovariance());
  return withWavesOfShapes(half.transpose());
}

Eigen::VectorXd RingModel::standing() const {
  if (order_ == 0) return solution_;
  constexpr double kStands = 3.0;  // power over that of its error: as much by chance in 5 % of waves
  const Eigen::MatrixXd covariance = solvedCovariance();
  Eigen::VectorXd datum = datumShares().cwiseProduct(solution_.head(datumCount()));
  for (Eigen::Index j = 3; j < waveCount(); j += 2) {
    if (datum.segment<2>(j).squaredNorm() < kStands * (covariance(j, j) + covariance(j + 1, j + 1)))
      datum.segment<2>(j).setZero();
  }
  datum.head<3>() += plane_;
  return withWavesOfShapes(datum);
}

std::vector<RingModel::Local> RingModel::locals() const {
  std::vector<Local> locals;
  if (shapes_.empty()) return locals;
  const Eigen::VectorXd datum = coefficients();
  const Eigen::MatrixXd errors = covariance();
  const auto local_of = [&](const LocalShape& shape) {
    const Eigen::MatrixXd rows =
        rowsAt(Eigen::Vector3d(shape.centre, shape.centre - shape.half_width, shape.centre + shape.half_width));
    const Eigen::RowVectorXd bent = rows.row(0) - 0.5 * (rows.row(1) + rows.row(2));
    return Local{shape, bent.dot(datum), std::sqrt(bent * errors * bent.transpose())};
  };
  for (const LocalShape& shape : shapes_) {
    if (shape.detail) continue;
    const Local here = local_of(shape);
    const auto same = std::find_if(locals.begin(), locals.end(),
                                   [&here](const Local& other) { return here.shape.isWithin(other.shape); });
    if (same == locals.end()) {
      locals.push_back(here);
    } else if (here.height * same->height > 0.0) {
      *same = local_of(here.shape.joinedWith(same->shape));
    } else if (std::abs(here.height) > std::abs(same->height)) {
      *same = here;  // a bend the other way at its flank is none of its own
    }
  }
  return locals;
}

Eigen::MatrixXd RingModel::rowsAt(const Eigen::VectorXd& azimuths) const {
  Eigen::MatrixXd rows(azimuths.size(), datumCount());
  rows.leftCols(waveCount()) = harmonicRows(azimuths, order_);
  for (std::size_t k = 0; k < shapes_.size(); ++k) {
    const Eigen::VectorXd waves = shapes_[k].waves(order_);
    for (Eigen::Index i = 0; i < azimuths.size(); ++i) {
      rows(i, waveCount() + static_cast<Eigen::Index>(k)) =
          shapes_[k].at(azimuths[i]) - rows.row(i).head(waveCount()).dot(waves);
    }
  }
  return rows;
}

RingModel::Simulated RingModel::simulate(int draws, std::uint64_t seed) const {
  Deviates normal(seed);
  const Eigen::Index waves = waveCount(), datum = datumCount(), all = normal_.rows();
  const Eigen::VectorXd widths = drawnWidths(normal, noise_.freedom, draws), shares = datumShares();
  const Eigen::MatrixXd spread = posterior_.matrixU().solve(drawn(normal, all, draws)) * widths.asDiagonal();
  Eigen::MatrixXd truth = shares.asDiagonal() * spread.topRows(datum);
  const Eigen::VectorXd own = shares.head(waves).cwiseProduct(errors_).cwiseSqrt();
  truth.topRows(waves) += own.asDiagonal() * drawn(normal, waves, draws);
  truth.colwise() += shares.cwiseProduct(solution_.head(datum));

  // the same survey of that datum: its waves and fresh errors of neighbours, setups, and stations
  Eigen::MatrixXd seen(all, draws);
  seen.topRows(datum) = truth;
  seen.topRows(waves) += errors_.cwiseSqrt().asDiagonal() * drawn(normal, waves, draws);
  seen.bottomRows(all - datum) = drawn(normal, all - datum, draws);
  const Eigen::MatrixXd own_errors =
      (noise_.scale * data_.sigmas).asDiagonal() * drawn(normal, data_.count(), draws) * widths.asDiagonal();
  Simulated result;
  result.survey = product(design_, seen) + own_errors;
  const Eigen::VectorXd weights = (noise_.scale * data_.sigmas).array().square().inverse();
  const Eigen::MatrixXd sums = product((weights.asDiagonal() * design_).transpose(), result.survey);
  result.survey.colwise() += harmonicRows(data_.azimuths, 1) * plane_;
  const Eigen::MatrixXd solved = posterior_.solve(sums).topRows(datum);
  result.estimate = withWavesOfShapes(shares.asDiagonal() * solved);
  result.truth = withWavesOfShapes(truth);
  result.estimate.topRows<3>().colwise() += plane_;
  result.truth.topRows<3>().colwise() += plane_;
  return result;
}

}  // namespace tank_datum
