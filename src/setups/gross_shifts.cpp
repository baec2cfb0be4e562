#include "setups/gross_shifts.h"

#include <algorithm>
#include <cmath>

namespace tank_datum {
namespace {

/// What counts of a setup's error as gross: its height, its place, or both.
SetupMotion grossPartOf(const SetupMotion& error, double least) {
  SetupMotion gross;
  if (std::abs(error.dz) > least) gross.dz = error.dz;
  if (std::hypot(error.dx, error.dy) > least) gross.dx = error.dx, gross.dy = error.dy;
  return gross;
}

bool isGross(const SetupMotion& shift) { return !shift.vector().isZero(0.0); }

/// In how many arcs every setup is compared with others.
std::vector<std::size_t> comparedIn(const std::vector<ArcView>& arcs, std::size_t setups) {
  std::vector<std::size_t> counts(setups, 0);
  for (const ArcView& arc : arcs) {
    for (const std::size_t setup : arc.seen.setups) ++counts[setup];
  }
  return counts;
}

}  // namespace

std::vector<ArcView> viewWithGrossShifts(const std::function<std::vector<ArcView>(const ViewScope&)>& view,
                                         std::size_t setups, double reach, const SetupOptions& options) {
  constexpr double kFarther = 5.0;     // times the usual window
  constexpr double kGross = 0.5;       // of the usual window
  constexpr std::size_t kFew = 3'000;  // points of an arc tell millimetres
  const std::vector<ArcView> usual = view({});
  ViewScope wide;
  wide.window *= kFarther;
  wide.most_of_arc = kFew;
  const SetupAdjustment coarse = adjustSetups(view(wide), setups, options);
  ViewScope scope;
  for (std::size_t s = 0; s < setups; ++s) {
    const auto at = static_cast<Eigen::Index>(s) * SetupMotion::kParameters;
    const SetupMotion error = SetupMotion::of(coarse.errors.segment<SetupMotion::kParameters>(at));
    scope.shifts.push_back(grossPartOf(error, kGross * scope.window * reach));
  }
  if (std::none_of(scope.shifts.begin(), scope.shifts.end(), isGross)) return usual;
  const std::vector<ArcView> shifted = view(scope);
  const std::vector<std::size_t> before = comparedIn(usual, setups), after = comparedIn(shifted, setups);
  bool all = true;
  for (std::size_t s = 0; s < setups; ++s) {
    if (!isGross(scope.shifts[s]) || after[s] > before[s]) continue;
    scope.shifts[s] = {};
    all = false;
  }
  return all ? shifted : view(scope);
}

}  // namespace tank_datum
