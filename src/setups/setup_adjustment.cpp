#include "setups/setup_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "setups/bad_setups.h"
#include "setups/overlaps.h"
#include "setups/setup_system.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

// What a good surveyor reaches: taken where nothing is said and the overlaps do not tell.
constexpr KindSigmas kUsual{0.002, 10.0 / 3600.0 * kPi / 180.0, 0.002};

/// The sigmas to adjust with, and which of them come from the overlaps.
KindSigmas chooseSigmas(const SetupSystem& system, const KindSigmas& usual, const SetupOptions& options,
                        const std::vector<bool>& freed, SetupAdjustment& result) {
  constexpr double kEnough = 3.1;     // parameters determined: more than two setups tell of heights and tilts
  constexpr double kEnoughOf = 0.25;  // of the tilts: of fewer, heights explain all that short overlaps show
  std::array<bool, kParameterKinds> held = {options.error > 0.0, options.tilt > 0.0, options.error > 0.0};
  const Eigen::VectorXd priors = priorSigmas(usual, freed);
  const SetupSolution first = solveSetups(system, priors);
  const ErrorsByKind seen = errorsByKind(first, priors, freed);
  const auto free_count = static_cast<double>(std::count(freed.begin(), freed.end(), true));
  const bool heights = first.determined[0] + first.determined[1] - 3.0 * free_count >= kEnough;
  const double tilts_free = 2.0 * (static_cast<double>(freed.size()) - free_count);
  const bool tilts = heights && first.determined[1] - 2.0 * free_count >= kEnoughOf * tilts_free;
  const bool places = first.determined[2] - 2.0 * free_count >= kEnough;
  result.height_estimated = heights && !held[0];
  result.tilt_estimated = tilts && !held[1];
  result.plan_estimated = places && !held[2];
  const std::array<bool, kParameterKinds> given = held;
  held = {held[0] || !heights, held[1] || !tilts, held[2] || !places};
  KindSigmas sigmas = estimateSigmas(system, usual, held, freed);
  const SetupSolution solution = solveSetups(system, priorSigmas(sigmas, freed));
  const KindSigmas others = {held[1] ? 0.0 : sigmas[1] / usual[1], held[0] ? 0.0 : sigmas[0] / usual[0], 0.0};
  for (const std::size_t k : {2U, 1U, 0U}) {
    // nothing makes a registration better in height than it is seen to be in plan
    const double places_err = k == 0 && result.plan_estimated ? sigmas[2] : 0.0;
    const double known = std::max(1.0, solution.determined[k] - (k == 0 ? 1.0 : 2.0) * free_count);
    // tilts that overlaps do not show are as good as their heights are seen to be, if these are not just usual
    const double ratio = sigmas[0] / usual[0];
    const double alike = k == 1 && !held[0] ? std::max(std::min(1.0, ratio / kFarBetter), ratio) : 1.0;
    sigmas[k] = given[k]  ? usual[k]
                : held[k] ? std::max(alike * assumedSigma(usual[k], seen.squares[k], seen.determined[k]), places_err)
                          : temperedSigma(sigmas[k], known, std::max(usual[k], places_err), others[k]);
  }
  return sigmas;
}

/// Two groups of the setups that are not bad.
SetupGroups groupsOf(const SetupAdjustment& result) {
  std::vector<double> heights(result.bad.size(), kUnknown);
  for (std::size_t s = 0; s < heights.size(); ++s) {
    if (!result.bad[s] && std::isfinite(result.rms_before[s])) heights[s] = result.errorOf(s).dz;
  }
  return twoGroups(heights);
}

/// Makes bad setups of the smaller group where it is plainly farther off than usual, and no more may be bad than are
/// then: its setups support each other, so that none of them stands out.
bool freeSmaller(SetupAdjustment& result, const KindSigmas& usual) {
  constexpr double kPlainly = 3.0;  // sigmas
  if (!(result.groups.apart > kPlainly * usual[0])) return false;
  std::vector<bool> bad = result.bad;
  for (std::size_t s = 0; s < bad.size(); ++s) bad[s] = bad[s] || result.groups.smaller()[s];
  if (static_cast<std::size_t>(std::count(bad.begin(), bad.end(), true)) > mostBad(bad.size())) return false;
  for (std::size_t s = 0; s < bad.size(); ++s) result.freed[s] = result.freed[s] || result.groups.smaller()[s];
  result.bad = bad;
  return true;
}

/// Of two groups either may be right, or neither: all heights may err together by half of what is between.
void doubtGroups(SetupAdjustment& result) {
  const double common = square(0.5 * result.groups.apart);
  for (Eigen::Index row = 0; row < result.errors.size(); row += SetupMotion::kParameters) {
    for (Eigen::Index column = 0; column < result.errors.size(); column += SetupMotion::kParameters)
      result.covariance(row, column) += common;
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
  result.freed = result.bad;
  SetupSolution solution;
  KindSigmas sigmas = usual;
  const auto solve = [&](const SetupSystem& system) {
    sigmas = chooseSigmas(system, usual, options, result.freed, result);
    solution = solveSetups(system, priorSigmas(sigmas, result.freed));
  };
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const SetupSystem system = overlaps.system();
    // the first rounds learn the arcs' own errors, for which the setups' may be anything
    if (iteration >= 2 && iteration + 1 < kIterations && options.bad != BadSetups::Keep) {
      result.bad = badSetups(overlaps, usual, kNamed);
      result.freed = result.bad;
      if (std::count(result.bad.begin(), result.bad.end(), true) > 0) {
        const std::vector<bool> beyond_doubt = badSetups(overlaps, usual, kFreed);
        for (std::size_t s = 0; s < setups; ++s) result.freed[s] = result.bad[s] && beyond_doubt[s];
      }
    }
    if (iteration < 2) {
      solution = solveSetups(system, priorSigmas({5.0 * usual[0], 5.0 * usual[1], 5.0 * usual[2]}, result.freed));
    } else {
      solve(system);
    }
    if (iteration + 1 < kIterations) overlaps.learnFrom(solution);
  }
  const auto take = [&] {
    result.errors = solution.errors;
    result.covariance = solution.covariance;
    result.spread = {sigmas[0], sigmas[1], sigmas[2]};
    measureDiscrepancy(overlaps, result);
    result.groups = groupsOf(result);
  };
  take();
  if (options.bad != BadSetups::Keep && freeSmaller(result, usual)) {
    solve(overlaps.system());
    take();
  }
  doubtGroups(result);
  return result;
}

}  // namespace tank_datum
