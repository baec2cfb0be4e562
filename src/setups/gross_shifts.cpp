#include "setups/gross_shifts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/units.h"

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

bool anyGross(const std::vector<SetupMotion>& shifts) { return std::any_of(shifts.begin(), shifts.end(), isGross); }

/// Numbers of arcs, rising.
using ArcNumbers = std::vector<std::size_t>;

/// The arcs in which a setup is compared with others.
/// @param shell  whether those of the shell, else of the foundation
ArcNumbers comparedIn(const std::vector<ArcView>& arcs, std::size_t setup, bool shell) {
  ArcNumbers numbers;
  for (const ArcView& arc : arcs) {
    const std::vector<std::size_t>& seen = arc.seen.setups;
    if (arc.shell == shell && std::find(seen.begin(), seen.end(), setup) != seen.end()) numbers.push_back(arc.number);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// How many arcs are among some and not among others.
std::size_t countBeside(const ArcNumbers& some, const ArcNumbers& others) {
  ArcNumbers beside;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(beside));
  return beside.size();
}

/// Whether a shift lets a setup be compared in far more arcs than are lost by it: one that sees soil on half of its
/// arcs is not off.
bool letsCompare(const std::vector<ArcView>& before, const std::vector<ArcView>& after, std::size_t setup, bool shell) {
  constexpr std::size_t kFarMore = 4;  // times
  const ArcNumbers usual = comparedIn(before, setup, shell), shifted = comparedIn(after, setup, shell);
  const std::size_t gained = countBeside(shifted, usual), lost = countBeside(usual, shifted);
  return gained > kFarMore * lost;
}

}  // namespace

std::vector<ArcView> viewWithGrossShifts(const std::function<std::vector<ArcView>(const ViewScope&)>& view,
                                         std::size_t setups, double reach, const SetupOptions& options) {
  constexpr double kFarther = 5.0;     // times the usual window
  constexpr double kGross = 0.5;       // of the usual window
  constexpr double kSame = 0.25;       // of the usual window: what a setup is off twice
  constexpr double kLevel = 60.0;      // arc-seconds, six times the usual: what passes for more is soil on one side
  constexpr double kLeft = 3.0;        // times what the arcs of all leave: another surface than theirs leaves more
  constexpr std::size_t kFew = 3'000;  // points of an arc tell millimetres
  const std::vector<ArcView> usual = view({});
  ViewScope wide, scope;
  const double window = scope.window * reach;
  wide.window *= kFarther;
  wide.most_of_arc = kFew;
  const SetupAdjustment coarse = adjustSetups(view(wide), setups, options);
  for (std::size_t s = 0; s < setups; ++s) scope.shifts.push_back(grossPartOf(coarse.errorOf(s), kGross * window));
  if (!anyGross(scope.shifts)) return usual;
  const std::vector<ArcView> shifted = view(scope);
  const SetupAdjustment again = adjustSetups(shifted, setups, options);
  bool all = true;
  for (std::size_t s = 0; s < setups; ++s) {
    SetupMotion& shift = scope.shifts[s];
    if (!isGross(shift)) continue;
    const SetupMotion looked_for = shift;
    const SetupMotion error = again.errorOf(s);
    const bool is_level = toArcSeconds(std::hypot(error.tilt_x, error.tilt_y)) <= kLevel,
               fits = std::abs(error.dz - shift.dz) <= kSame * window && again.rms_after[s] <= kLeft * again.all_after;
    if (!is_level || !fits || !letsCompare(usual, shifted, s, false)) shift.dz = 0.0;
    if (!letsCompare(usual, shifted, s, true) || std::hypot(error.dx - shift.dx, error.dy - shift.dy) > kSame * window)
      shift.dx = shift.dy = 0.0;
    all = all && shift.vector() == looked_for.vector();
  }
  if (all) return shifted;
  return anyGross(scope.shifts) ? view(scope) : usual;
}

}  // namespace tank_datum
