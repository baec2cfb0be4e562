#include "shape/ring_model.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "shape/ring_likelihood.h"
#include "stations/station_covariance.h"

namespace tank_datum {
namespace {

constexpr Eigen::Index kMostSparse = 64;  ///< stations: up to so many, each stands for its own arc
constexpr int kHighestWave = 45;

int orderFor(Eigen::Index stations) {
  return static_cast<int>(stations > kMostSparse ? std::min<Eigen::Index>(kHighestWave, stations / 4)
                                                 : std::max<Eigen::Index>(1, (stations - 1) / 2));
}

}  // namespace

RingData ringData(const std::vector<Station>& stations, double radius, const StationCovariance& covariance) {
  constexpr double kUsualWave = 1.0 / 4000.0;  // of a foundation, over the radius
  RingData data;
  data.usual_wave = kUsualWave * radius;
  const StationCovariance given = covariance.empty() ? independentCovariance(stations) : covariance;
  std::vector<Eigen::Index> measured;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (stations[i].flag == StationFlag::Measured) measured.push_back(static_cast<Eigen::Index>(i));
  }
  const auto count = static_cast<Eigen::Index>(measured.size());
  data.azimuths.resize(count), data.z.resize(count), data.sigmas.resize(count);
  data.shared.resize(given.factors.rows(), count);
  data.sigmas_known = count > 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index i = measured[static_cast<std::size_t>(k)];
    const Station& s = stations[static_cast<std::size_t>(i)];
    data.azimuths[k] = s.azimuth, data.z[k] = s.z, data.sigmas[k] = given.independent[i];
    if (given.factors.rows() > 0) data.shared.col(k) = given.factors.col(i);
    data.sigmas_known = data.sigmas_known && given.independent[i] > 0.0;
  }
  return data;
}

Eigen::MatrixXd RingModel::rowsAt(const Eigen::VectorXd& azimuths, int order) {
  Eigen::MatrixXd rows(azimuths.size(), 2 * order + 1);
  for (Eigen::Index i = 0; i < azimuths.size(); ++i) rows.row(i) = harmonicRow(azimuths[i], order);
  return rows;
}

Eigen::MatrixXd RingModel::product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd result(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) result.col(j).noalias() = a * b.col(j);
  return result;
}

bool RingModel::dense() const { return data_.count() > kMostSparse; }

RingModel::RingModel(const RingData& data) : data_(data), order_(orderFor(data.count())) {
  constexpr Eigen::Index kFewest = 4;
  if (data_.count() < kFewest) {
    order_ = 0, mean_ = errors_ = Eigen::VectorXd::Zero(1);
    return;
  }
  const Eigen::Index waves = 2 * order_ + 1, unknowns = waves + data_.shared.rows();
  offset_ = data_.z.mean();
  const Eigen::VectorXd z = data_.z.array() - offset_;
  if (!data_.sigmas_known) {
    constexpr double kLeast = 1e-7;  // [m]: of a datum level to within rounding
    const double scatter = std::sqrt(z.squaredNorm() / static_cast<double>(data_.count()));
    data_.sigmas.setConstant(data_.count(), std::max(kLeast, 0.1 * scatter));
  }
  design_.resize(data_.count(), unknowns);
  design_.leftCols(waves) = rowsAt(data_.azimuths, order_);
  design_.rightCols(data_.shared.rows()) = data_.shared.transpose();
  const Eigen::VectorXd weights = data_.sigmas.array().square().inverse();
  const Eigen::MatrixXd weighted = weights.asDiagonal() * design_;
  normal_ = product(weighted.transpose(), design_);
  rhs_ = weighted.transpose() * z;
  squares_ = z.dot(weights.cwiseProduct(z));
  estimatePriors();
  solve();
}

/// Scatter of the stations over their sigmas by third differences, which sharp places of the datum hardly move.
double RingModel::differencesScale() const {
  const double norm = std::sqrt(20.0), step = kTwoPi / static_cast<double>(data_.count());
  std::vector<double> differences;
  for (Eigen::Index i = 3; i < data_.count(); ++i) {
    if (data_.azimuths[i] - data_.azimuths[i - 3] > 4.5 * step) continue;  // over a gap
    const double third = data_.z[i] - 3.0 * data_.z[i - 1] + 3.0 * data_.z[i - 2] - data_.z[i - 3];
    differences.push_back(third / (norm * data_.sigmas[i]));
  }
  return robustSigma(differences, 0.0);
}

/// Variance of the stations' own errors over sigmas^2: what the waves, all free, leave of many stations, or third
/// differences where those say much less; what a plane leaves of few without sigmas.
double RingModel::ownScale2() {
  constexpr double kRidge = 1e-8, kLeast = 1e-6, kSharp = 2.0;
  const bool many = dense();
  if (!many && data_.sigmas_known) return 1.0;
  const Eigen::Index used = many ? normal_.rows() : 3;
  Eigen::MatrixXd normal = normal_.topLeftCorner(used, used);
  normal.diagonal() *= 1.0 + kRidge;
  const Eigen::VectorXd solution = normal.llt().solve(rhs_.head(used));
  const Eigen::VectorXd left = data_.z.array() - offset_ - (design_.leftCols(used) * solution).array();
  noise_.freedom = static_cast<double>(data_.count() - used);
  double scale = std::sqrt(left.cwiseQuotient(data_.sigmas).squaredNorm() / noise_.freedom);
  const double differences = many ? differencesScale() : scale;
  if (kSharp * differences < scale) scale = differences;
  return std::max(kLeast * kLeast, scale * scale);
}

void RingModel::estimatePriors() {
  const bool many = dense();
  const double scale2 = ownScale2();
  const double usual = std::sqrt(1.0 / data_.sigmas.array().square().inverse().mean());
  RingPriors priors;
  const bool shape = many || data_.sigmas_known;  // else residuals cannot tell shape from error
  if (shape) {
    const RingSums sums{normal_, rhs_, squares_, data_.count(), order_, scale2};
    RingBeliefs beliefs{data_.sigmas_known ? usual : usual * std::sqrt(scale2), data_.usual_wave, {}};
    // errors that stations do not show beside each other are shared ones
    if (many) beliefs.neighbours = data_.sigmas_known ? usual * std::sqrt(std::max(0.0, 1.0 - scale2)) : 0.0;
    priors = likeliestPriors(sums, beliefs);
  }
  noise_.neighbours = priors.neighbours, noise_.length = priors.neighbours > 0.0 ? priors.length : 0.0;
  noise_.repeatability = std::sqrt(scale2 + std::pow(priors.neighbours / usual, 2.0));
  if (data_.sigmas_known && scale2 < 1.0) noise_.freedom = 0.0;
  noise_.scale = std::sqrt(data_.sigmas_known ? std::max(1.0, scale2) : scale2);
  constexpr double kAllowance = 1.5;  // in variance, for waves that no power of their number describes
  waves_ = kAllowance * waveVariances(priors, order_);
  errors_ = errorVariances(priors, order_);
  if (!shape) errors_.setZero();
}

void RingModel::solve() {
  constexpr double kLeastVariance = 1e-18, kBelief = 2.0;
  constexpr int kRounds = 6;
  const Eigen::Index waves = 2 * order_ + 1;
  const double scale2 = noise_.scale * noise_.scale;
  Eigen::VectorXd solution;
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd precision = normal_ / scale2;
    for (Eigen::Index j = 3; j < waves; ++j) precision(j, j) += 1.0 / std::max(waves_[j] + errors_[j], kLeastVariance);
    for (Eigen::Index j = waves; j < precision.rows(); ++j) precision(j, j) += 1.0;
    posterior_.compute(precision);
    solution = posterior_.solve(rhs_ / scale2);
    if (round + 1 == kRounds) break;
    const Eigen::MatrixXd inverse = posterior_.solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
    const auto power = [&](Eigen::Index j) {  // expected square of the datum's part of a coefficient
      const double share = waves_[j] / (waves_[j] + errors_[j] + kLeastVariance);
      return share * errors_[j] + share * share * (solution[j] * solution[j] + inverse(j, j));
    };
    for (Eigen::Index j = 3; j < waves; j += 2) {
      const double lifted = (kBelief * waves_[j] + power(j) + power(j + 1)) / (kBelief + 2.0);
      waves_[j] = waves_[j + 1] = std::max(waves_[j], lifted);
    }
  }
  mean_ = solution.head(waves);
  for (Eigen::Index j = 3; j < waves; ++j) mean_[j] *= waves_[j] / (waves_[j] + errors_[j] + kLeastVariance);
  mean_[0] += offset_;
}

Eigen::MatrixXd RingModel::covariance() const {
  if (order_ == 0) return Eigen::MatrixXd::Zero(1, 1);
  const Eigen::Index waves = 2 * order_ + 1, all = normal_.rows();
  const Eigen::MatrixXd inverse = posterior_.solve(Eigen::MatrixXd::Identity(all, all));
  Eigen::VectorXd shares = Eigen::VectorXd::Ones(waves), own = errors_;
  for (Eigen::Index j = 3; j < waves; ++j) {
    shares[j] = waves_[j] / (waves_[j] + errors_[j] + 1e-18);
    own[j] = shares[j] * errors_[j];
  }
  Eigen::MatrixXd covariance = shares.asDiagonal() * inverse.topLeftCorner(waves, waves) * shares.asDiagonal();
  covariance.diagonal() += own;
  return covariance;
}

}  // namespace tank_datum
