#include "movement/movement_errors.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "movement/ring_pairs.h"

namespace tank_datum {
namespace {

/// The part of two windows that they share, over the root of both: the correlation of means of white noise over them.
double overlapOf(const MatchedStation& a, const MatchedStation& b) {
  const double apart = std::abs(std::remainder(a.direction - b.direction, kTwoPi));
  const double shared = std::min({a.window, b.window, 0.5 * (a.window + b.window) - apart});
  return shared > 0.0 ? shared / (std::sqrt(a.window) * std::sqrt(b.window)) : 0.0;
}

/// Takes from the values each of the waves n = 2 to 5 that no error of neighbours makes: with a power far above that of
/// the waves above it. An error shared over 20 degrees has ten times the power at n = 2 that it has at n = 8, and
/// chance adds five times. Of few stations fewer waves are there to compare with, three at least.
/// @return how many
int removeStandingWaves(std::vector<double>& values, const std::vector<MatchedStation>& stations,
                        const RingPairs& pairs) {
  constexpr int kFewestOthers = 3;
  constexpr double kStands = 50.0, kDearest = 5.0;
  const auto count = static_cast<Eigen::Index>(values.size());
  const int highest = std::min(14, static_cast<int>(count - 1) / 2), longest = std::min(5, highest / 2);
  if (highest - longest < kFewestOthers) return 0;
  Eigen::MatrixXd rows(count, 2 * highest + 1);
  for (Eigen::Index i = 0; i < count; ++i)
    rows.row(i) = harmonicRow(stations[static_cast<std::size_t>(i)].direction, highest);
  const Eigen::LLT<Eigen::MatrixXd> normal(rows.transpose() * rows);
  const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(rows.cols(), rows.cols()));
  if (!(inverse.diagonal().maxCoeff() < kDearest * 2.0 / static_cast<double>(count))) return 0;  // a gap
  const Eigen::VectorXd given = Eigen::Map<const Eigen::VectorXd>(values.data(), count);
  const Eigen::VectorXd waves = normal.solve(rows.transpose() * given);
  const auto power = [&](int n) { return waves.segment<2>(2 * n - 1).squaredNorm(); };
  std::vector<double> powers;
  for (int n = longest + 1; n <= highest; ++n) powers.push_back(power(n));
  const double usual = median(powers);
  std::vector<double> rest = values;
  int standing = 0;
  for (int n = 2; n <= longest; ++n) {
    if (power(n) <= kStands * usual) continue;
    ++standing;
    const Eigen::VectorXd wave = rows.middleCols(2 * n - 1, 2) * waves.segment<2>(2 * n - 1);
    for (Eigen::Index i = 0; i < count; ++i) rest[static_cast<std::size_t>(i)] -= wave[i];
  }
  // the waves of a sector that moved would move the others
  if (standing == 0 || pairs.scatterOf(rest) >= pairs.scatterOf(values)) return 0;
  values = rest;
  return standing;
}

}  // namespace

MovementErrors shownErrors(const std::vector<MatchedStation>& stations) {
  constexpr std::size_t kFewStations = 16;
  constexpr double kMismatch = 1.25;    // few stations exceed their sigma by less through chance
  constexpr double kEfficiency = 0.87;  // of biweightSigma
  constexpr double kNone = 0.35;        // correlations below it are none: a wide movement of one sigma makes as much
  constexpr double kCautious = 1.25;    // an arc is known to about a quarter
  constexpr double kMisstated = 4.0;    // errors are not stated by more too small: beyond, the tank moved
  constexpr double kOfWindows = 2.0;    // an arc that is learnt, of errors that share no more than points
  MovementErrors errors;
  const std::size_t n = stations.size();
  const Removed level(stations, Removal::Tilt, true);
  std::vector<double> values;
  for (const MatchedStation& m : level.stations) values.push_back(m.dz / m.sigma);
  const RingPairs pairs(stations);
  const int waves = removeStandingWaves(values, stations, pairs);
  const double scatter = pairs.scatterOf(values);
  double along = 0.0;
  for (std::size_t lag = 1; lag <= pairs.widest(); ++lag) {
    const double correlation = pairs.correlationAt(values, lag, scatter);
    if (!(correlation > kNone)) break;  // NaN too: no pairs are left
    along += correlation;
  }
  if (along > 0.0) errors.shared = kCautious * pairs.step() * (1.0 + 2.0 * along);
  // the plane took three degrees of freedom from as many values as are independent, and each wave two
  const double independent = errors.shared > 0.0 ? std::max(6.0, pairs.step() * static_cast<double>(n) / errors.shared)
                                                 : static_cast<double>(n);
  const double taken = errors.shared > 0.0 ? 3.0 : 3.0 + 2.0 * waves;
  errors.shown = scatter / std::sqrt(1.0 - taken / independent);
  const double freedom = std::max(1.0, kEfficiency * (independent - taken));
  if (errors.shared > 0.0) errors.freedom_whole = freedom;  // the arc is known no better than a scale would be
  if (errors.shown <= (n < kFewStations ? kMismatch : 1.0)) return errors;
  // what neighbours share by their windows alone is no movement
  const bool is_noise = pairs.widest() > 0 && errors.shared < kOfWindows * medianWindow(stations);
  errors.scale = is_noise ? errors.shown : std::min(kMisstated, errors.shown);
  if (errors.scale < errors.shown) return errors;
  if (errors.shown > kMismatch) errors.freedom = errors.freedom_whole = freedom;
  return errors;
}

void widenErrors(std::vector<MatchedStation>& stations, const MovementErrors& errors, double declared) {
  for (MatchedStation& m : stations) {
    m.sigma_baseline = std::hypot(errors.scale * m.ownOfBaseline(), m.sharedOfBaseline());
    m.sigma = std::hypot(errors.scale * m.own(), m.shared.norm());
    m.window = declared > 0.0 ? declared : std::max(m.window, errors.shared);
  }
}

CommonMotion commonMotion(const std::vector<MatchedStation>& stations, double height, double rim) {
  const auto count = static_cast<Eigen::Index>(stations.size());
  Eigen::MatrixXd rows(count, 3), covariance(count, count);
  Eigen::VectorXd dz(count), weights(count), own(count);
  for (Eigen::Index i = 0; i < count; ++i) own[i] = stations[static_cast<std::size_t>(i)].own();
  for (Eigen::Index i = 0; i < count; ++i) {
    const MatchedStation& m = stations[static_cast<std::size_t>(i)];
    rows.row(i) << 1.0, portable::cos(m.direction), portable::sin(m.direction);
    dz[i] = m.dz, weights[i] = 1.0 / (m.sigma * m.sigma);
    for (Eigen::Index j = 0; j < count; ++j) {
      const MatchedStation& other = stations[static_cast<std::size_t>(j)];
      covariance(i, j) = own[i] * own[j] * overlapOf(m, other) + m.shared.dot(other.shared);
    }
  }
  const Eigen::MatrixXd weighted = rows.transpose() * weights.asDiagonal();
  const Eigen::MatrixXd fit = (weighted * rows).ldlt().solve(weighted);
  Eigen::MatrixXd spread(3, count);
  for (Eigen::Index j = 0; j < count; ++j) spread.col(j) = fit * covariance.col(j);
  const Eigen::Matrix3d errors = spread.lazyProduct(fit.transpose());
  const Eigen::Vector3d motion = fit * dz;
  CommonMotion result;
  result.mean = motion[0], result.sigma_mean = std::sqrt(errors(0, 0) + height * height);
  result.rim = motion.tail<2>();
  result.covariance = errors.bottomRightCorner<2, 2>() + rim * rim * Eigen::Matrix2d::Identity();
  return result;
}

double tiltPValue(const CommonMotion& motion, double freedom) {
  const double squares = motion.rim.dot(motion.covariance.inverse() * motion.rim);
  return freedom > 0.0 ? portable::pow(1.0 + squares / freedom, -0.5 * freedom) : portable::exp(-0.5 * squares);
}

}  // namespace tank_datum
