#include "setups/overlaps.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/least_without.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

Eigen::Index at(std::size_t setup) { return static_cast<Eigen::Index>(setup) * SetupMotion::kParameters; }

constexpr double kPlace = 6.0 * kPi / 180.0;  // to either side the same thing may be seen that is not the tank's

double apart(double azimuth, double other) { return std::abs(std::remainder(azimuth - other, kTwoPi)); }

SetupSystem empty(std::size_t setups) {
  const auto size = static_cast<Eigen::Index>(setups) * SetupMotion::kParameters;
  return {Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
}

Eigen::MatrixXd informationOf(const ArcView& arc, double extra) {
  const Eigen::MatrixXd& own = arc.seen.information;
  const Eigen::MatrixXd wider = Eigen::MatrixXd::Identity(own.rows(), own.cols()) + extra * extra * own;
  const Eigen::MatrixXd both = wider.ldlt().solve(own);
  return 0.5 * (both + both.transpose());
}

/// What one setup is off the mean of the others in an arc, squared.
struct Discrepancy {
  std::size_t setup;
  double before, after;
};

/// Root mean squares of those that the adjustment explains: of the others something else than the foundation was seen.
std::pair<double, double> rmsOf(const std::vector<Discrepancy>& all) {
  constexpr double kElse = 5.0 * 5.0 / 0.455;  // times the median of squares that are left
  std::vector<double> left;
  for (const Discrepancy& d : all) left.push_back(d.after);
  const double most = kElse * median(left);
  double before = 0.0, after = 0.0, used = 0.0;
  for (const Discrepancy& d : all) {
    if (d.after > most) continue;
    before += d.before;
    after += d.after;
    used += 1.0;
  }
  if (used == 0.0) return {kUnknown, kUnknown};
  return {std::sqrt(before / used), std::sqrt(after / used)};
}

}  // namespace

void Overlaps::add(std::size_t a, SetupSystem& sum) const {
  const ArcView& arc = arcs_[a];
  const Eigen::MatrixXd information = weights_[a] * informationOf(arc, extra_[arc.shell]);
  const Eigen::VectorXd right = information * arc.seen.offsets;
  for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto to = at(arc.seen.setups[i]);
    sum.right.segment<SetupMotion::kParameters>(to) += arc.motion.row(row).transpose() * right[row];
    for (std::size_t j = 0; j < arc.seen.setups.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      sum.matrix.block<SetupMotion::kParameters, SetupMotion::kParameters>(to, at(arc.seen.setups[j])) +=
          information(row, column) * arc.motion.row(row).transpose() * arc.motion.row(column);
    }
  }
}

SetupSystem Overlaps::system() const {
  SetupSystem sum = empty(setups_);
  for (std::size_t a = 0; a < arcs_.size(); ++a) add(a, sum);
  return sum;
}

SetupSystem Overlaps::systemWithout(double azimuth) const {
  SetupSystem sum = empty(setups_);
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    if (apart(arcs_[a].azimuth, azimuth) > kPlace) add(a, sum);
  }
  return sum;
}

std::vector<double> Overlaps::placesOf(std::size_t setup) const {
  constexpr double kStep = 0.5 * kPlace;
  std::vector<double> places;
  for (const ArcView& arc : arcs_) {
    const std::vector<std::size_t>& seen = arc.seen.setups;
    if (std::find(seen.begin(), seen.end(), setup) == seen.end()) continue;
    if (places.empty() || apart(arc.azimuth, places.back()) > kStep) places.push_back(arc.azimuth);
  }
  return places;
}

void Overlaps::learnFrom(const SetupSolution& solution) {
  for (const bool shell : {false, true}) {
    const double extra = extraOf(solution, shell);
    extra_[shell] = extra;
  }
  constexpr double kFar = 2.5;  // in sigmas, from where on an arc counts less (Huber)
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    const double off = std::sqrt(misfit(arcs_[a], solution.errors, extra_[arcs_[a].shell]));
    weights_[a] = off > kFar ? tukeyWeight(off - kFar) * kFar / off : 1.0;
  }
}

Eigen::VectorXd Overlaps::left(const ArcView& arc, const Eigen::VectorXd& errors) const {
  Eigen::VectorXd left = arc.seen.offsets;
  for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    left[row] -= arc.motion.row(row).dot(errors.segment<SetupMotion::kParameters>(at(arc.seen.setups[i])));
  }
  left.array() -= left.mean();
  return left;
}

double Overlaps::misfit(const ArcView& arc, const Eigen::VectorXd& errors, double extra) const {
  const Eigen::VectorXd rest = left(arc, errors);
  const auto freedom = static_cast<double>(arc.seen.setups.size() - 1);
  return rest.dot(informationOf(arc, extra) * rest) / chiSquareQuantile(freedom, 0.0);
}

double Overlaps::extraOf(const SetupSolution& solution, bool shell) const {
  constexpr double kWidest = 0.1;  // [m]
  double freedom = 0.0;
  for (const ArcView& arc : arcs_) {
    if (arc.shell == shell) freedom += static_cast<double>(arc.seen.setups.size() - 1);
  }
  const double told = shell ? solution.determined[2] : solution.determined[0] + solution.determined[1];
  if (freedom < 2.0) return 0.0;
  const double inflation = freedom / std::max(0.5 * freedom, freedom - told);
  const auto excess = [&](double extra) {
    std::vector<double> misfits;
    for (const ArcView& arc : arcs_) {
      if (arc.shell == shell) misfits.push_back(misfit(arc, solution.errors, extra));
    }
    return inflation * median(misfits) - 1.0;
  };
  return leastWithout(excess, kWidest, 20);
}

void measureDiscrepancy(const Overlaps& overlaps, SetupAdjustment& result) {
  std::vector<Discrepancy> all;
  for (const ArcView& arc : overlaps.arcs()) {
    if (arc.shell) continue;
    const Eigen::VectorXd after = overlaps.left(arc, result.errors);
    const auto many = static_cast<double>(arc.seen.setups.size()), scale = many / (many - 1.0);
    for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      all.push_back({arc.seen.setups[i], square(scale * arc.seen.offsets[row]), square(scale * after[row])});
    }
  }
  std::tie(result.all_before, result.all_after) = rmsOf(all);
  result.rms_before.clear(), result.rms_after.clear();
  for (std::size_t s = 0; s < result.bad.size(); ++s) {
    std::vector<Discrepancy> own;
    std::copy_if(all.begin(), all.end(), std::back_inserter(own), [s](const Discrepancy& d) { return d.setup == s; });
    const auto [before, after] = rmsOf(own);
    result.rms_before.push_back(before);
    result.rms_after.push_back(after);
  }
}

}  // namespace tank_datum
