#include "shape/ring_model.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "stations/ring_series.h"

namespace tank_datum {
namespace {

constexpr double kLeastScale2 = 1e-8;     ///< of stations without sigmas, however smooth: less is lost in rounding
constexpr Eigen::Index kMostSparse = 64;  ///< stations: up to so many, each stands for its own arc
constexpr int kHighestWave = 45;
constexpr double kRidge = 1e-8;  ///< a short arc hardly tells mean and tilt apart

/// The least distance of neighbours [rad].
double leastStep(const Eigen::VectorXd& azimuths) {
  std::vector<double> places;
  for (const double azimuth : azimuths) places.push_back(turnAhead(0.0, azimuth));
  std::sort(places.begin(), places.end());
  double least = turnAhead(places.back(), places.front());
  for (std::size_t i = 1; i < places.size(); ++i) least = std::min(least, places[i] - places[i - 1]);
  return least;
}

/// Of many stations, waves that leave residuals enough to tell errors by. Of few, those that neighbours show, the
/// closest too: longer ones would have to be beyond all measure in the gaps to follow a single station.
int orderFor(const Eigen::VectorXd& azimuths) {
  constexpr int kHighestOfFew = 90;
  const Eigen::Index stations = azimuths.size();
  if (stations > kMostSparse) return static_cast<int>(std::min<Eigen::Index>(kHighestWave, stations / 4));
  const auto usual = static_cast<double>(stations - 1) / 2.0;
  const double closest = 0.5 * (kTwoPi / std::max(leastStep(azimuths), 1e-3) - 1.0) + 1e-6;
  return std::max(1, static_cast<int>(std::min<double>(kHighestOfFew, std::max(usual, closest))));
}

}  // namespace

Eigen::MatrixXd RingModel::product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd result(a.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) result.col(j).noalias() = a * b.col(j);
  return result;
}

bool RingModel::dense() const { return data_.count() > kMostSparse; }

RingModel::RingModel(const RingData& data) : data_(data) {
  constexpr Eigen::Index kFewestStations = 4;
  if (data_.count() < kFewestStations) {
    solution_ = errors_ = Eigen::VectorXd::Zero(1);
    return;
  }
  order_ = orderFor(data_.azimuths);
  if (!data_.sigmas_known) {
    constexpr double kLeast = 1e-7;  // [m]: of a datum level to within rounding
    const double scatter = std::sqrt((data_.z.array() - data_.z.mean()).square().mean());
    data_.sigmas.setConstant(data_.count(), std::max(kLeast, 0.1 * scatter));
  }
  takeOutPlane();
  compareWithSigmas();
  setUp(dense() ? standingShapes() : std::vector<LocalShape>());
  estimatePriors(ownScale2());
  solve();
  data_.z += harmonicRows(data_.azimuths, 1) * plane_;
}

/// Takes the best plane out of z. What is solved for is how far the datum's mean and tilt are from it: what waves as
/// large as the plane leaves, all along the arc, might do to them, and no more than some times that (Zellner's
/// g-prior). Else the tilt of a short arc and the waves that it hides are traded for each other without bounds.
void RingModel::takeOutPlane() {
  constexpr double kWide = 10.0;
  const Eigen::MatrixXd rows = harmonicRows(data_.azimuths, 1);
  const auto count = static_cast<double>(data_.count());
  Eigen::Matrix3d normal = rows.transpose() * rows;
  normal.diagonal() *= 1.0 + kRidge;
  plane_ = normal.llt().solve(rows.transpose() * data_.z);
  data_.z -= rows * plane_;
  const double usual2 = data_.sigmas_known ? 1.0 / data_.sigmas.array().square().inverse().mean() : 0.0;
  const double left = data_.z.squaredNorm() / count + usual2 + kLeastVariance;
  plane_precision_ = normal / (count * kWide * kWide * left);
}

/// A datum has shape beside its plane, so that stations depart from it by more than their errors. Where they do by a
/// third of them, sigmas are not what the survey's errors were: typed in another unit, or by far too careful.
void RingModel::compareWithSigmas() {
  constexpr double kOverstated = 1.0 / 3.0;
  const auto freedom = static_cast<double>(data_.count() - 3);
  noise_.about_plane = std::sqrt(data_.z.cwiseQuotient(data_.sigmas).squaredNorm() / freedom);
  noise_.is_overstated = data_.sigmas_known && noise_.about_plane < kOverstated;
}

/// Adds the likeliest shape again and again, and keeps as many as make the stations likeliest: several shapes hide each
/// other while each is taken for errors. Each must raise the odds more than the best of all places does by chance.
std::vector<LocalShape> RingModel::standingShapes() {
  constexpr int kMost = 8, kInVain = 3;
  constexpr double kOdds = 10.0;
  const std::vector<CandidateShape> candidates = candidateShapes(data_.azimuths, data_.directions);
  const double each = 2.0 * portable::log(kOdds * static_cast<double>(candidates.size()));
  setUp({});
  const double scale2 = robustScale2();
  std::vector<LocalShape> best;
  double least = estimatePriors(scale2);
  int last = 0;
  for (int count = 1; count <= kMost && count - last <= kInVain; ++count) {
    const Eigen::VectorXd weights = data_.sigmas.array().square().inverse() / (noise_.scale * noise_.scale);
    const Eigen::VectorXd residuals = data_.z - design_ * solution_;
    const auto next = likeliestShape({weights, residuals, design_, posterior_}, candidates);
    if (!next) break;
    std::vector<LocalShape> shapes = shapes_;
    for (const LocalShape& part : withDetails(*next, kTwoPi / static_cast<double>(data_.count())))
      shapes.push_back(part);
    setUp(shapes);
    const double misfit = estimatePriors(scale2) + count * each;
    if (misfit < least) least = misfit, best = shapes, last = count;
  }
  return best;
}

void RingModel::setUp(const std::vector<LocalShape>& shapes) {
  shapes_ = shapes;
  design_.resize(data_.count(), datumCount() + data_.shared.rows());
  design_.leftCols(waveCount()) = harmonicRows(data_.azimuths, order_);
  for (std::size_t k = 0; k < shapes_.size(); ++k) {
    for (Eigen::Index i = 0; i < data_.count(); ++i)
      design_(i, waveCount() + static_cast<Eigen::Index>(k)) = shapes_[k].scale * shapes_[k].at(data_.azimuths[i]);
  }
  design_.rightCols(data_.shared.rows()) = data_.shared.transpose();
  const Eigen::VectorXd weights = data_.sigmas.array().square().inverse();
  const Eigen::MatrixXd weighted = weights.asDiagonal() * design_;
  normal_ = product(weighted.transpose(), design_);
  rhs_ = weighted.transpose() * data_.z;
  squares_ = data_.z.dot(weights.cwiseProduct(data_.z));
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

/// What all unknowns, or the first so many, leave of the stations when they are free, over their sigmas. Pivoted: a gap
/// leaves some sums of waves, and shapes within it, without any station.
RingModel::Left RingModel::leftOf(Eigen::Index used) const {
  const Eigen::VectorXd weights = data_.sigmas.cwiseInverse(), z = weights.cwiseProduct(data_.z);
  const Eigen::MatrixXd design = weights.asDiagonal() * design_.leftCols(used);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(design);
  return {z - design * decomposition.solve(z), static_cast<double>(data_.count() - decomposition.rank())};
}

/// The same of many stations by the median, which a few that stand out hardly move; given sigmas are the least.
double RingModel::robustScale2() const {
  const Left left = leftOf(normal_.rows());
  const double scale = robustSigma(std::vector<double>(left.residuals.begin(), left.residuals.end()), 0.0);
  const double part = std::max(1.0, left.freedom) / static_cast<double>(data_.count());
  return std::max(data_.sigmas_known ? 1.0 : kLeastScale2, scale * scale / part);
}

/// Variance of the stations' own errors over sigmas^2: what the waves, all free, leave of many stations, or third
/// differences where those say much less; what a plane leaves of few without sigmas.
double RingModel::ownScale2() {
  constexpr double kSharp = 2.0;
  const bool many = dense();
  if (!many && data_.sigmas_known) return 1.0;
  const Left left = leftOf(many ? normal_.rows() : 3);
  noise_.freedom = std::max(1.0, left.freedom);
  double scale = std::sqrt(left.residuals.squaredNorm() / noise_.freedom);
  const double differences = many ? differencesScale() : scale;
  if (kSharp * differences < scale) scale = differences;
  return std::max(kLeastScale2, scale * scale);
}

/// Finds the priors. Returns -2 ln of their likelihood, less a constant.
double RingModel::estimatePriors(double scale2) {
  const bool many = dense();
  const double usual = std::sqrt(1.0 / data_.sigmas.array().square().inverse().mean());
  RingPriors priors;
  double misfit = 0.0;
  const bool shape = many || data_.sigmas_known;  // else residuals cannot tell shape from error
  if (shape) {
    const RingSums sums{normal_, rhs_, squares_, data_.count(), order_, scale2};
    RingHyperprior hyperprior{data_.sigmas_known ? usual : usual * std::sqrt(scale2), data_.usual_wave, {}};
    // errors that stations do not show beside each other are shared ones
    if (many) hyperprior.neighbours = data_.sigmas_known ? usual * std::sqrt(std::max(0.0, 1.0 - scale2)) : 0.0;
    std::tie(priors, misfit) = likeliestPriors(sums, hyperprior);
  }
  noise_.neighbours = priors.neighbours, noise_.length = priors.neighbours > 0.0 ? priors.length : 0.0;
  noise_.repeatability = std::sqrt(scale2 + square(priors.neighbours / usual));
  if (data_.sigmas_known && scale2 < 1.0) noise_.freedom = 0.0;
  noise_.scale = std::sqrt(data_.sigmas_known ? std::max(1.0, scale2) : scale2);
  constexpr double kAllowance = 1.5;  // in variance, for waves that no power of their number describes
  waves_ = kAllowance * waveVariances(priors, order_);
  errors_ = errorVariances(priors, order_);
  if (!shape) errors_.setZero();
  factorPrecision();
  return misfit + static_cast<double>(data_.count()) * portable::log(scale2) + squares_ / scale2;
}

void RingModel::factorPrecision() {
  Eigen::MatrixXd precision = normal_ / (noise_.scale * noise_.scale);
  precision.topLeftCorner<3, 3>() += plane_precision_;
  for (Eigen::Index j = 3; j < precision.rows(); ++j)
    precision(j, j) += j < waveCount() ? 1.0 / std::max(waves_[j] + errors_[j], kLeastVariance) : 1.0;
  posterior_.compute(precision);
  solution_ = posterior_.solve(rhs_ / (noise_.scale * noise_.scale));
}

/// Widens the prior of each wave that stands above what the others say.
void RingModel::solve() {
  constexpr double kPriorWeight = 2.0;  // in coefficients seen
  constexpr int kRounds = 6;
  for (int round = 0; round + 1 < kRounds; ++round) {
    const Eigen::MatrixXd inverse = posterior_.solve(Eigen::MatrixXd::Identity(normal_.rows(), normal_.cols()));
    const auto power = [&](Eigen::Index j) {  // expected square of the datum's part of a coefficient
      const double share = waves_[j] / (waves_[j] + errors_[j] + kLeastVariance);
      return share * errors_[j] + share * share * (solution_[j] * solution_[j] + inverse(j, j));
    };
    for (Eigen::Index j = 3; j < waveCount(); j += 2) {
      const double lifted = (kPriorWeight * waves_[j] + power(j) + power(j + 1)) / (kPriorWeight + 2.0);
      waves_[j] = waves_[j + 1] = std::max(waves_[j], lifted);
    }
    factorPrecision();
  }
}

}  // namespace tank_datum
