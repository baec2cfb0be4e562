#include "setups/setup_adjustment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/statistics.h"
#include "core/units.h"
#include "setups/setup_system.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

// What a good surveyor reaches: taken where nothing is said and the overlaps do not tell.
constexpr KindSigmas kUsual{0.002, 10.0 / 3600.0 * kPi / 180.0, 0.002};

/// The arcs with the errors they have on top of their points'.
class Overlaps {
 public:
  Overlaps(const std::vector<ArcView>& arcs, std::size_t setups)
      : arcs_(arcs), setups_(setups), weights_(arcs.size(), 1.0) {}

  SetupSystem system() const {
    const auto size = static_cast<Eigen::Index>(setups_) * SetupMotion::kParameters;
    SetupSystem sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
    for (std::size_t a = 0; a < arcs_.size(); ++a) {
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
    return sum;
  }

  /// Errors of the arcs, and weights, from what the solution leaves over.
  void learnFrom(const SetupSolution& solution) {
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

  /// Offsets that the errors do not explain.
  Eigen::VectorXd left(const ArcView& arc, const Eigen::VectorXd& errors) const {
    Eigen::VectorXd left = arc.seen.offsets;
    for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      left[row] -= arc.motion.row(row).dot(errors.segment<SetupMotion::kParameters>(at(arc.seen.setups[i])));
    }
    left.array() -= left.mean();
    return left;
  }

 private:
  static Eigen::Index at(std::size_t setup) { return static_cast<Eigen::Index>(setup) * SetupMotion::kParameters; }

  static Eigen::MatrixXd informationOf(const ArcView& arc, double extra) {
    const Eigen::MatrixXd& own = arc.seen.information;
    const Eigen::MatrixXd wider = Eigen::MatrixXd::Identity(own.rows(), own.cols()) + extra * extra * own;
    const Eigen::MatrixXd both = wider.ldlt().solve(own);
    return 0.5 * (both + both.transpose());
  }

  /// Square of what is left in an arc over what is expected, per degree of freedom: its median is 1 in the mean.
  double misfit(const ArcView& arc, const Eigen::VectorXd& errors, double extra) const {
    const Eigen::VectorXd rest = left(arc, errors);
    const auto freedom = static_cast<double>(arc.seen.setups.size() - 1);
    const double median_of_chi_squared = freedom * std::pow(1.0 - 2.0 / (9.0 * freedom), 3);
    return rest.dot(informationOf(arc, extra) * rest) / median_of_chi_squared;
  }

  /// The error common to an arc's points for which the median misfit is 1 (after Mandel and Paule 1970).
  double extraOf(const SetupSolution& solution, bool shell) const {
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
    double low = 0.0, high = kWidest;
    if (excess(low) <= 0.0) return 0.0;
    for (int halving = 0; halving < 20; ++halving) (excess(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    return high;
  }

  const std::vector<ArcView>& arcs_;
  std::size_t setups_;
  std::vector<double> weights_;
  double extra_[2] = {0.0, 0.0};
};

/// How far a setup lies beyond what its sigmas allow, the setup freed of its priors: the larger of two squares over
/// their bounds, for its height and tilts and for its place. Beyond 1 it is bad.
double beyond(const SetupSolution& freed, std::size_t setup, const KindSigmas& sigmas) {
  constexpr double kBound3 = 13.93, kBound2 = 11.62;  // chi squared of 3 and 2 at 0.3 %
  const Eigen::Index at = static_cast<Eigen::Index>(setup) * SetupMotion::kParameters;
  Eigen::MatrixXd spread = freed.covariance.block<SetupMotion::kParameters, SetupMotion::kParameters>(at, at);
  for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) spread(i, i) += sigmas[kindOf(i)] * sigmas[kindOf(i)];
  const SetupMotion::Vector error = freed.errors.segment<SetupMotion::kParameters>(at);
  const Eigen::Vector3d upright = error.head<3>();
  const Eigen::Vector2d place = error.tail<2>();
  return std::max(upright.dot(spread.topLeftCorner<3, 3>().ldlt().solve(upright)) / kBound3,
                  place.dot(spread.bottomRightCorner<2, 2>().ldlt().solve(place)) / kBound2);
}

/// Sigmas of the setups that are not freed (one step of expectation and maximisation), drawn towards the usual ones by
/// so many setups' worth.
KindSigmas sigmasOfOthers(const SetupSolution& solution, const KindSigmas& usual, const std::vector<bool>& freed) {
  constexpr double kUsualWorth = 6.0;
  KindSigmas squares{}, counts{}, sigmas{};
  for (Eigen::Index i = 0; i < solution.errors.size(); ++i) {
    if (freed[static_cast<std::size_t>(i / SetupMotion::kParameters)]) continue;
    squares[kindOf(i)] += solution.errors[i] * solution.errors[i] + solution.covariance(i, i);
    counts[kindOf(i)] += 1.0;
  }
  for (std::size_t k = 0; k < kParameterKinds; ++k) {
    const double worth = kUsualWorth * (k == 0 ? 1.0 : 2.0);
    sigmas[k] = std::sqrt((squares[k] + worth * usual[k] * usual[k]) / (counts[k] + worth));
  }
  return sigmas;
}

/// The same for a setup by itself, its own error kept out of the others' sigmas.
double beyondOthers(const SetupSystem& system, const KindSigmas& usual, std::vector<bool> freed, std::size_t setup) {
  freed[setup] = true;
  KindSigmas sigmas = usual;
  for (int pass = 0; pass < 2; ++pass) {
    sigmas = sigmasOfOthers(solveSetups(system, priorSigmas(sigmas, freed)), usual, freed);
  }
  return beyond(solveSetups(system, priorSigmas(sigmas, freed)), setup, sigmas);
}

/// The setup furthest beyond what its sigmas allow, or none. Those with the largest errors are looked at.
std::size_t worstSetup(const SetupSystem& system, const KindSigmas& usual, const std::vector<bool>& freed) {
  constexpr std::size_t kLookedAt = 8;
  const std::size_t count = freed.size();
  const SetupSolution solution = solveSetups(system, priorSigmas(usual, freed));
  std::vector<std::pair<double, std::size_t>> suspects;
  for (std::size_t s = 0; s < count; ++s) {
    double square = 0.0;
    for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) {
      const double error = solution.errors[static_cast<Eigen::Index>(s) * SetupMotion::kParameters + i];
      square += error * error / (usual[kindOf(i)] * usual[kindOf(i)]);
    }
    if (!freed[s]) suspects.emplace_back(-square, s);
  }
  std::sort(suspects.begin(), suspects.end());
  suspects.resize(std::min(suspects.size(), kLookedAt));
  std::size_t worst = count;
  double most = 1.0;
  for (const auto& suspect : suspects) {
    const double far = beyondOthers(system, usual, freed, suspect.second);
    if (far > most) most = far, worst = suspect.second;
  }
  return worst;
}

/// The bad setups: one of three to nine, one in five of more. Where there seem to be more than that none is an
/// exception, and the sigma of all is large.
std::vector<bool> badSetups(const SetupSystem& system, const KindSigmas& usual, std::size_t setups) {
  constexpr std::size_t kFewest = 3, kOneIn = 5;
  const std::size_t most = std::max<std::size_t>(1, setups / kOneIn);
  std::vector<bool> bad(setups, false);
  for (std::size_t found = 0; setups >= kFewest; ++found) {
    const std::size_t worst = worstSetup(system, usual, bad);
    if (worst == setups) break;
    if (found == most) return std::vector<bool>(setups, false);
    bad[worst] = true;
  }
  return bad;
}

/// The sigmas to adjust with, and which of them come from the overlaps.
KindSigmas chooseSigmas(const SetupSystem& system, const KindSigmas& usual, const SetupOptions& options,
                        const std::vector<bool>& freed, SetupAdjustment& result) {
  constexpr double kEnough = 3.0;  // parameters determined
  std::array<bool, kParameterKinds> held = {options.error > 0.0, options.tilt > 0.0, options.error > 0.0};
  const SetupSolution first = solveSetups(system, priorSigmas(usual, freed));
  const auto free_count = static_cast<double>(std::count(freed.begin(), freed.end(), true));
  const bool heights = first.determined[0] + first.determined[1] - 3.0 * free_count >= kEnough;
  const bool places = first.determined[2] - 2.0 * free_count >= kEnough;
  result.height_estimated = heights && !held[0];
  result.plan_estimated = places && !held[2];
  held = {held[0] || !heights, held[1] || !heights, held[2] || !places};
  KindSigmas sigmas = estimateSigmas(system, usual, held, freed);
  const SetupSolution solution = solveSetups(system, priorSigmas(sigmas, freed));
  for (std::size_t k = 0; k < kParameterKinds; ++k) {
    if (held[k]) continue;
    const double known = std::max(1.0, solution.determined[k] - (k == 0 ? 1.0 : 2.0) * free_count);
    sigmas[k] = temperedSigma(sigmas[k], known, usual[k]);
  }
  return sigmas;
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

/// Of the foundation: each setup against the mean of the others in its arcs, and all of them together.
void measureDiscrepancy(const std::vector<ArcView>& arcs, const Overlaps& overlaps, SetupAdjustment& result) {
  std::vector<Discrepancy> all;
  for (const ArcView& arc : arcs) {
    if (arc.shell) continue;
    const Eigen::VectorXd after = overlaps.left(arc, result.errors);
    const auto many = static_cast<double>(arc.seen.setups.size()), scale = many / (many - 1.0);
    for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      all.push_back({arc.seen.setups[i], std::pow(scale * arc.seen.offsets[row], 2), std::pow(scale * after[row], 2)});
    }
  }
  std::tie(result.all_before, result.all_after) = rmsOf(all);
  for (std::size_t s = 0; s < result.bad.size(); ++s) {
    std::vector<Discrepancy> own;
    std::copy_if(all.begin(), all.end(), std::back_inserter(own), [s](const Discrepancy& d) { return d.setup == s; });
    const auto [before, after] = rmsOf(own);
    result.rms_before.push_back(before);
    result.rms_after.push_back(after);
  }
}

}  // namespace

SetupAdjustment adjustSetups(const std::vector<ArcView>& arcs, std::size_t setups, const SetupOptions& options) {
  constexpr int kIterations = 6;
  const KindSigmas usual = {options.error > 0.0 ? options.error : kUsual[0],
                            options.tilt > 0.0 ? options.tilt : kUsual[1],
                            options.error > 0.0 ? options.error : kUsual[2]};
  Overlaps overlaps(arcs, setups);
  SetupAdjustment result;
  result.bad.assign(setups, false);
  SetupSolution solution;
  KindSigmas sigmas = usual;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const SetupSystem system = overlaps.system();
    // the first rounds learn the arcs' own errors, for which the setups' may be anything
    if (iteration >= 2 && iteration + 1 < kIterations) {
      result.bad = options.bad == BadSetups::Keep ? std::vector<bool>(setups, false) : badSetups(system, usual, setups);
    }
    sigmas = iteration < 2 ? KindSigmas{5.0 * usual[0], 5.0 * usual[1], 5.0 * usual[2]}
                           : chooseSigmas(system, usual, options, result.bad, result);
    solution = solveSetups(system, priorSigmas(sigmas, result.bad));
    if (iteration + 1 < kIterations) overlaps.learnFrom(solution);
  }
  result.errors = solution.errors;
  result.covariance = solution.covariance;
  result.spread = {sigmas[0], sigmas[1], sigmas[2]};
  measureDiscrepancy(arcs, overlaps, result);
  return result;
}

}  // namespace tank_datum
