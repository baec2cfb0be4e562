#include "movement/azimuth_offset.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/portable_math.h"
#include "core/units.h"
#include "movement/epoch_matching.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr double kElsewhere = 10.0 * kDegree;  ///< another turn, and no error of this one

/// Mean squared standardised difference at a turn, without what is common: a tilt that has changed would turn the
/// shape. NaN with too few stations.
double misfitAt(const Epoch& baseline, const Epoch& current, double offset) {
  std::vector<MatchedStation> matched = matchStations(baseline, current, offset).stations;
  const std::size_t sparser = std::min(baseline.judgeable(), current.judgeable());
  if (2 * matched.size() < sparser || matched.empty()) return std::nan("");
  const Removed rest(std::move(matched), Removal::Tilt, false);
  double sum = 0;
  for (const MatchedStation& m : rest.stations) sum += square(m.dz / m.sigma);
  return sum / static_cast<double>(rest.stations.size());
}

/// Variance of an azimuth offset [rad^2].
/// @param independent  what it were if the stations shared nothing but points [rad^2]
/// @param information  of the offset [rad^-2], by the curvature of the misfit: slopes from station to station are noisy
double offsetVariance(std::vector<MatchedStation> stations, double independent, double information) {
  for (MatchedStation& m : stations) m.dz = m.slope;
  const Removed slopes(std::move(stations), Removal::Tilt, false);
  double own = 0.0;
  Eigen::VectorXd shared = Eigen::VectorXd::Zero(slopes.stations.front().shared.size());
  for (const MatchedStation& m : slopes.stations) {
    own += square(m.own() / m.sigma);
    shared += m.dz / square(m.sigma) * m.shared;
  }
  return independent * own / static_cast<double>(slopes.stations.size()) + shared.squaredNorm() / square(information);
}

/// Variance of an azimuth offset by what the shapes differ by at the turn found [rad^2]. Of a tank that moved, the part
/// along the slopes is lost in the turn, so what is left tells little of it: the waves of the slopes are taken to have
/// moved, in an unknown phase, by as much as the largest wave of the differences.
double shownVariance(const std::vector<MatchedStation>& stations, double information) {
  constexpr int kFirst = 2, kLast = 12;
  const Removed rest(stations, Removal::Tilt, false);
  double largest = 0.0;
  for (int wave = kFirst; wave <= kLast; ++wave) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const MatchedStation& m : rest.stations)
      sum += m.dz / m.sigma * Eigen::Vector2d(portable::cos(wave * m.direction), portable::sin(wave * m.direction));
    largest = std::max(largest, sum.squaredNorm());
  }
  return largest / (static_cast<double>(stations.size()) * information);
}

}  // namespace

AzimuthOffset estimateOffset(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  constexpr int kSteps = 720;
  constexpr double kStep = kTwoPi / kSteps;
  const auto at = [&](double offset) { return misfitAt(baseline, current, offset); };
  std::vector<double> misfits;
  int best = -1;
  for (int i = 0; i < kSteps; ++i) {
    misfits.push_back(at(i * kStep));
    if (std::isfinite(misfits.back()) && (best < 0 || misfits.back() < misfits[static_cast<std::size_t>(best)]))
      best = i;
  }
  double second = std::nan("");
  for (int i = 0; i < kSteps && best >= 0; ++i) {
    const double away = std::abs(std::remainder((i - best) * kStep, kTwoPi));
    if (away > kElsewhere && !(misfits[static_cast<std::size_t>(i)] >= second)) {
      if (std::isfinite(misfits[static_cast<std::size_t>(i)])) second = misfits[static_cast<std::size_t>(i)];
    }
  }
  // the parabola through three turns two degrees apart
  constexpr double kReach = 4 * kStep;
  const double middle = best < 0 ? std::nan("") : misfits[static_cast<std::size_t>(best)];
  const double before = at(best * kStep - kReach), after = at(best * kStep + kReach);
  const double curvature = (before - 2.0 * middle + after) / (kReach * kReach);
  if (!(curvature > 0.0) || !(second > 2.0 * std::max(middle, 1.0))) {
    throw Error(Error::Kind::Option, "movement", "azimuth offset",
                "the datum's shape out of plane fits more than one turn", "an azimuth offset that is given");
  }
  AzimuthOffset offset;
  offset.value = std::remainder(best * kStep - 0.5 * (after - before) / (2.0 * kReach) * 2.0 / curvature, kTwoPi);
  // neighbours share points: as many independent differences as their windows fit into the turn
  const std::vector<MatchedStation> matched = matchStations(baseline, current, offset.value).stations;
  const auto count = static_cast<double>(matched.size());
  const double shared = options.correlation > 0.0 ? options.correlation : medianWindow(matched);
  const double independent = std::min(count, kTwoPi / std::max(shared, kStep)), information = 0.5 * count * curvature;
  const double stated = offsetVariance(matched, 2.0 * std::max(middle, 1.0) / (independent * curvature), information);
  offset.sigma = std::sqrt(std::max(stated, shownVariance(matched, information)));
  return offset;
}

bool fitsTurned(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  if (options.estimate_offset || options.azimuth_offset != 0.0) return false;
  try {
    return std::abs(estimateOffset(baseline, current, options).value) > kElsewhere;
  } catch (const Error&) {
    return false;  // no turn, or more than one
  }
}

}  // namespace tank_datum
