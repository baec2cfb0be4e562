#include "foot/foot_banks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/outer_sections.h"
#include "foot/section_end.h"
#include "foot/shell_below.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kNear = 5.0 * kDegree;  ///< within which a datum does little

/// The elevation nearest to a station on one side, and how many stations away; 0: none is near.
struct Beside {
  double level = kUnknown;
  std::size_t away = 0;
};

/// @param step  +1 or -1: the side that is looked at, up to `near` stations on
Beside besideOf(std::size_t station, int step, const std::vector<double>& levels, const std::vector<char>& leave_out,
                std::size_t near) {
  const std::size_t count = levels.size();
  for (std::size_t away = 1; away <= near; ++away) {
    const std::size_t i = (station + (step > 0 ? away : count - away)) % count;
    if (leave_out[i] == 0 && std::isfinite(levels[i])) return {levels[i], away};
  }
  return {};
}

/// How far a run of stations rises above the line between those beside it [m]; infinite where none is near.
/// @param leave_out  stations that are no measure of it
double riseOf(const RingRun& run, const std::vector<double>& levels, const std::vector<char>& leave_out,
              std::size_t near) {
  const std::size_t count = levels.size();
  Beside before = besideOf(run.first % count, -1, levels, leave_out, near);
  Beside after = besideOf(run.last % count, +1, levels, leave_out, near);
  if (before.away == 0 && after.away == 0) return std::numeric_limits<double>::infinity();
  if (before.away == 0) before = {after.level, 1};
  if (after.away == 0) after = {before.level, 1};
  const double length = static_cast<double>(run.last - run.first + before.away + after.away);
  double rise = 0.0;
  for (std::size_t i = run.first; i <= run.last; ++i) {
    if (!std::isfinite(levels[i % count])) continue;
    const double along = static_cast<double>(i - run.first + before.away) / length;
    rise = std::max(rise, levels[i % count] - before.level - along * (after.level - before.level));
  }
  return rise;
}

/// What the shell beside the end of a run says: whether it is seen to go on below the run's elevation. Where it is seen
/// by few points at each station, all tell it together; a foot that lies not much lower ends what there is of it.
enum class Says { Nothing, GoesOn, Ends };

/// @param allowed  by how much lower it may end where the run's surface does [m]
Says shellBeside(const Foot& foot, std::size_t end, int step, const std::vector<double>& levels, double allowed) {
  constexpr std::size_t kFewest = 3;  // stations whose shell is seen
  constexpr double kAllowed = 0.01;   // of the reach
  constexpr double kDepth = 0.02;     // of the reach: how much of it is looked at
  constexpr double kFalls = 0.005;    // along the shell, twice what the codes allow: a dip beside [m/m]
  const std::size_t count = levels.size(), near = foot.stationsIn(kNear);
  std::size_t seen = 0, below = 0;
  ShellCounts together;
  for (std::size_t away = 1; away <= near; ++away) {
    const std::size_t i = (end + (step > 0 ? away : count - away)) % count;
    if (!foot.shell_seen[i] || std::isfinite(levels[i])) continue;
    const double lower = kAllowed * foot.reach + allowed + kFalls * static_cast<double>(away) * foot.arc();
    const FootFit level = levelAt(foot, levels[end] - lower, 0.0);
    const ShellCounts counts = countShell(foot, i, level, leastBelow(foot, level) + kDepth * foot.reach);
    ++seen;
    below += counts.isGoodPart() ? 1 : 0;
    together.add(counts);
  }
  return seen < kFewest ? Says::Nothing : 2 * below > seen && together.goOn() ? Says::GoesOn : Says::Ends;
}

}  // namespace

std::vector<bool> findBanks(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels,
                            const std::vector<bool>& stood) {
  constexpr double kLeast = 0.008;  // of the reach
  constexpr double kShareUp = 0.5;  // of what it hides is what a bank rises by
  const std::size_t count = levels.size(), near = 2 * foot.stationsIn(kNear);
  const std::vector<RingSections> all = sectionsBeyond(foot, surface, levels, stood);
  std::vector<SectionSeen> seen;
  std::vector<Depth> depths;
  std::vector<char> lower;
  for (std::size_t i = 0; i < count; ++i) {
    seen.emplace_back(all, i);
    depths.push_back(seen[i].depth(kLeast * foot.reach));
    lower.push_back(depths[i].value > 0.0 ? 1 : 0);
  }
  std::vector<bool> banks(count, false);
  for (const RingRun& run : runsRound(lower, near)) {
    Depth deepest;
    for (std::size_t i = run.first; i <= run.last; ++i) {
      if (depths[i % count].value > deepest.value) deepest = depths[i % count];
    }
    std::vector<char> no_measure;  // where it would not be seen, a station may stand on the same bank
    for (std::size_t i = 0; i < count; ++i) no_measure.push_back(lower[i] || !seen[i].shows(deepest.from) ? 1 : 0);
    const double rise = riseOf(run, levels, no_measure, near);
    if (rise < kShareUp * deepest.value || (std::isinf(rise) && deepest.of_part)) continue;
    for (std::size_t i = run.first; i <= run.last; ++i) banks[i % count] = std::isfinite(levels[i % count]);
  }
  return banks;
}

std::vector<bool> findHangingRuns(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels) {
  constexpr std::size_t kOneEnd = 6, kBothEnds = 2;  // longer parts of the ring are no banks, with that many ends seen
  const std::size_t count = levels.size();
  std::vector<char> known(count);
  for (std::size_t i = 0; i < count; ++i) known[i] = std::isfinite(levels[i]) ? 1 : 0;
  std::vector<bool> hanging(count, false);
  const double drop = dropBeyond(surface), plate = drop > 0.0 && drop < kThickestPlate ? drop : 0.0;
  for (const RingRun& run : runsRound(known, foot.stationsIn(kNear))) {
    const Says before = shellBeside(foot, run.first % count, -1, levels, plate);
    const Says after = shellBeside(foot, run.last % count, +1, levels, plate);
    const bool either = before == Says::GoesOn || after == Says::GoesOn;
    const bool neither = before != Says::Ends && after != Says::Ends;
    if (!either || run.last - run.first >= count / (neither ? kBothEnds : kOneEnd)) continue;
    for (std::size_t i = run.first; i <= run.last; ++i) hanging[i % count] = known[i % count] != 0;
  }
  return hanging;
}

}  // namespace tank_datum
