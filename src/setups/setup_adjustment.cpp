#include "setups/setup_adjustment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/statistics.h"
#include "core/units.h"
#include "setups/overlaps.h"
#include "setups/setup_system.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

// What a good surveyor reaches: taken where nothing is said and the overlaps do not tell.
constexpr KindSigmas kUsual{0.002, 10.0 / 3600.0 * kPi / 180.0, 0.002};

/// How far off a setup is by chance once in 300 times, by the sigmas of the others.
struct Bounds {
  double usual_worth;  ///< setups' worth of the usual sigmas that the others' are drawn by
  bool estimates;      ///< whether the others' sigmas count as estimates from so many setups, else as known

  double of(double parameters, double others) const {
    constexpr double kDeviate = 2.748;  // of the normal distribution at 0.3 %
    if (!estimates) return chiSquareQuantile(parameters, kDeviate);
    return parameters * fQuantile(parameters, 2.0 * (others + usual_worth), kDeviate);  // a setup has two tilts
  }
};

/// A bad setup is named as a good surveyor's would be. Its priors are lifted only where few others leave no doubt: of
/// setups that are all badly registered one is far off by chance, and the sigmas of the others are too small then.
constexpr Bounds kNamed{6.0, false}, kFreed{3.0, true};

/// How far a setup lies beyond what its sigmas allow, the setup freed of its priors: the larger of two squares over
/// their bounds, for its height and tilts and for its place. Beyond 1 it is bad.
double beyond(const SetupSolution& freed, std::size_t setup, const KindSigmas& sigmas, const Bounds& bounds,
              double others) {
  const Eigen::Index at = static_cast<Eigen::Index>(setup) * SetupMotion::kParameters;
  Eigen::MatrixXd spread = freed.covariance.block<SetupMotion::kParameters, SetupMotion::kParameters>(at, at);
  for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) spread(i, i) += sigmas[kindOf(i)] * sigmas[kindOf(i)];
  const SetupMotion::Vector error = freed.errors.segment<SetupMotion::kParameters>(at);
  const Eigen::Vector3d upright = error.head<3>();
  const Eigen::Vector2d place = error.tail<2>();
  return std::max(upright.dot(spread.topLeftCorner<3, 3>().ldlt().solve(upright)) / bounds.of(3.0, others),
                  place.dot(spread.bottomRightCorner<2, 2>().ldlt().solve(place)) / bounds.of(2.0, others));
}

/// Sigmas of the setups that are not freed (one step of expectation and maximisation), drawn towards the usual ones by
/// so many setups' worth.
KindSigmas sigmasOfOthers(const SetupSolution& solution, const KindSigmas& usual, const std::vector<bool>& freed,
                          double usual_worth) {
  KindSigmas squares{}, counts{}, sigmas{};
  for (Eigen::Index i = 0; i < solution.errors.size(); ++i) {
    if (freed[static_cast<std::size_t>(i / SetupMotion::kParameters)]) continue;
    squares[kindOf(i)] += solution.errors[i] * solution.errors[i] + solution.covariance(i, i);
    counts[kindOf(i)] += 1.0;
  }
  for (std::size_t k = 0; k < kParameterKinds; ++k) {
    const double worth = usual_worth * (k == 0 ? 1.0 : 2.0);
    sigmas[k] = std::sqrt((squares[k] + worth * usual[k] * usual[k]) / (counts[k] + worth));
  }
  return sigmas;
}

/// The same for a setup by itself, its own error kept out of the others' sigmas.
double beyondOthers(const SetupSystem& system, const KindSigmas& usual, std::vector<bool> freed, std::size_t setup,
                    const Bounds& bounds) {
  freed[setup] = true;
  KindSigmas sigmas = usual;
  for (int pass = 0; pass < 2; ++pass) {
    sigmas = sigmasOfOthers(solveSetups(system, priorSigmas(sigmas, freed)), usual, freed, bounds.usual_worth);
  }
  const auto others = static_cast<double>(std::count(freed.begin(), freed.end(), false));
  return beyond(solveSetups(system, priorSigmas(sigmas, freed)), setup, sigmas, bounds, others);
}

/// A setup and how far it is beyond what its sigmas allow: 1 is at the bound.
struct Suspect {
  std::size_t setup = 0;
  double beyond = 0.0;
};

/// The setup furthest off. Those with the largest errors are looked at.
Suspect worstSetup(const SetupSystem& system, const KindSigmas& usual, const std::vector<bool>& freed,
                   const Bounds& bounds) {
  constexpr std::size_t kLookedAt = 8;
  const SetupSolution solution = solveSetups(system, priorSigmas(usual, freed));
  std::vector<std::pair<double, std::size_t>> suspects;
  for (std::size_t s = 0; s < freed.size(); ++s) {
    double square = 0.0;
    for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) {
      const double error = solution.errors[static_cast<Eigen::Index>(s) * SetupMotion::kParameters + i];
      square += error * error / (usual[kindOf(i)] * usual[kindOf(i)]);
    }
    if (!freed[s]) suspects.emplace_back(-square, s);
  }
  std::sort(suspects.begin(), suspects.end());
  suspects.resize(std::min(suspects.size(), kLookedAt));
  Suspect worst;
  for (const auto& suspect : suspects) {
    const double far = beyondOthers(system, usual, freed, suspect.second, bounds);
    if (far > worst.beyond) worst = {suspect.second, far};
  }
  return worst;
}

/// The bad setups: one of three to nine, one in five of more. Where one more is nearly as far off as the last of them
/// none is an exception, and the sigma of all is large.
std::vector<bool> badSetups(const SetupSystem& system, const KindSigmas& usual, std::size_t setups,
                            const Bounds& bounds) {
  constexpr std::size_t kFewestSetups = 3, kOneIn = 5;
  constexpr double kNearly = 0.5;
  const std::size_t most = std::max<std::size_t>(1, setups / kOneIn);
  std::vector<bool> bad(setups, false);
  double last = 0.0;
  for (std::size_t found = 0; setups >= kFewestSetups; ++found) {
    const Suspect worst = worstSetup(system, usual, bad, bounds);
    if (!(worst.beyond > 1.0)) break;
    if (found == most) return worst.beyond > kNearly * last ? std::vector<bool>(setups, false) : bad;
    bad[worst.setup] = true;
    last = worst.beyond;
  }
  return bad;
}

/// The sigmas to adjust with, and which of them come from the overlaps.
KindSigmas chooseSigmas(const SetupSystem& system, const KindSigmas& usual, const SetupOptions& options,
                        const std::vector<bool>& freed, SetupAdjustment& result) {
  constexpr double kEnough = 3.1;  // parameters determined: more than two setups tell of heights and tilts
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
  const KindSigmas others = {held[1] ? 0.0 : sigmas[1] / usual[1], held[0] ? 0.0 : sigmas[0] / usual[0], 0.0};
  for (std::size_t k = 0; k < kParameterKinds; ++k) {
    if (held[k]) continue;
    const double known = std::max(1.0, solution.determined[k] - (k == 0 ? 1.0 : 2.0) * free_count);
    sigmas[k] = temperedSigma(sigmas[k], known, usual[k], others[k]);
  }
  return sigmas;
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
  result.freed = result.bad;
  SetupSolution solution;
  KindSigmas sigmas = usual;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const SetupSystem system = overlaps.system();
    // the first rounds learn the arcs' own errors, for which the setups' may be anything
    if (iteration >= 2 && iteration + 1 < kIterations && options.bad != BadSetups::Keep) {
      result.bad = badSetups(system, usual, setups, kNamed);
      result.freed = badSetups(system, usual, setups, kFreed);
      for (std::size_t s = 0; s < setups; ++s) result.freed[s] = result.freed[s] && result.bad[s];
    }
    sigmas = iteration < 2 ? KindSigmas{5.0 * usual[0], 5.0 * usual[1], 5.0 * usual[2]}
                           : chooseSigmas(system, usual, options, result.freed, result);
    solution = solveSetups(system, priorSigmas(sigmas, result.freed));
    if (iteration + 1 < kIterations) overlaps.learnFrom(solution);
  }
  result.errors = solution.errors;
  result.covariance = solution.covariance;
  result.spread = {sigmas[0], sigmas[1], sigmas[2]};
  measureDiscrepancy(overlaps, result);
  return result;
}

}  // namespace tank_datum
