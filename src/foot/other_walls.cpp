#include "foot/other_walls.h"

#include <cmath>
#include <cstddef>

#include "core/ring_runs.h"

namespace tank_datum {
namespace {

/// Whether the shell's line jumps from a place to the next one, so many places on, by more than a shell bends.
bool steps(const ShellLine& from, const ShellLine& to, double arc) {
  constexpr double kSure = 4.0;  // standard errors
  return std::abs(from.radius - to.radius) > bendAlong(arc) + kSure * std::hypot(from.sigma_radius, to.sigma_radius);
}

/// Whether a step lies at a run's end: between the nearest line that is the shell's and the first few of the run, of
/// which those at the step blend with both.
/// @param first    of the run
/// @param inwards  places from one line to the next one into the run, round the ring
bool beginsWithStep(const std::vector<ShellLine>& lines, const std::vector<bool>& strays, std::size_t first,
                    std::size_t inwards, double arc) {
  constexpr std::size_t kBlend = 3;  // lines
  const std::size_t count = lines.size(), outwards = count - inwards;
  std::size_t beside = 1;
  const auto at = [&](std::size_t places) { return (first + places * outwards) % count; };
  while (beside < count && !(lines[at(beside)].seen() && !strays[at(beside)])) ++beside;
  if (beside == count) return false;
  std::size_t last = at(beside), away = 0, pairs = 0;
  for (std::size_t place = last; pairs <= kBlend && away < count;) {
    place = (place + inwards) % count, ++away;
    if (!lines[place].seen()) continue;
    if (steps(lines[last], lines[place], static_cast<double>(away) * arc)) return true;
    last = place, away = 0, ++pairs;
  }
  return false;
}

}  // namespace

std::vector<bool> findOtherWalls(const std::vector<ShellLine>& lines, const std::vector<bool>& strays, double arc) {
  const std::size_t count = lines.size();
  std::vector<bool> other(count, false);
  std::vector<char> off(strays.begin(), strays.end());
  for (const RingRun& run : runsRound(off)) {
    const bool stands_out = beginsWithStep(lines, strays, run.first % count, 1, arc) &&
                            beginsWithStep(lines, strays, run.last % count, count - 1, arc);
    if (!stands_out) continue;
    for (std::size_t i = run.first; i <= run.last; ++i) other[i % count] = true;
  }
  return other;
}

}  // namespace tank_datum
