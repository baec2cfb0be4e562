#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "fit/surface_rows.h"
#include "foot/foot_choice.h"
#include "foot/foot_profile.h"
#include "foot/foot_state.h"
#include "foot/lowest_layer.h"
#include "foot/shell_below.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {
namespace {

/// Whether a window's rows of points fill the section beside the shell well enough to tell its stretches apart.
bool isFilled(const std::vector<FootPoint>& points, const FootScales& scales, double near) {
  constexpr std::size_t kCells = 10, kFilled = 7;  // of a fiftieth of the reach each
  constexpr int kFewestInCell = 10;
  std::array<int, kCells> counts{};
  for (const FootPoint& p : points) {
    const double cell = (p.d - near) / (0.02 * scales.reach);
    if (cell >= 0.0 && cell < static_cast<double>(kCells)) ++counts[static_cast<std::size_t>(cell)];
  }
  const auto full = std::count_if(counts.begin(), counts.end(), [](int count) { return count >= kFewestInCell; });
  return static_cast<std::size_t>(full) >= kFilled;
}

/// Takes out what a surface climbs along the shell, as beside a dip, where points about it scatter much less for that:
/// a section over several degrees would smear it.
void flatten(std::vector<FootPoint>& points, const FootScales& scales) {
  constexpr double kMuch = 0.5;
  constexpr double kOwn = 0.9;  // of how distances scatter, what goes along with no place along the shell
  SurfaceRows rows;
  rows.reserve(points.size());
  for (const FootPoint& p : points) {
    if (p.d >= scales.nearest()) rows.add(p.d, p.t, p.z);
  }
  if (rows.size() == 0) return;
  rows.close();
  SurfaceRows level = rows;
  SurfacePrior no_climb;
  no_climb.precision << 0.0, 0.0, 1e12, 1e12;
  const auto fit = fitRobustly(rows), as_level = fitRobustly(level, no_climb);
  if (!fit || !as_level || !(fit->noise < kMuch * as_level->noise)) return;
  const Eigen::Matrix4d& sums = fit->normal;
  const double distances =
      sums(1, 1) - sums(0, 1) * sums(0, 1) / sums(0, 0);  // of which rows that slant show a part alone
  if (!(kOwn * distances * fit->inverse(1, 1) < 1.0)) return;
  for (FootPoint& p : points) p.z -= (fit->solution[2] + fit->solution[3] * p.t) * p.t;
}

/// The stretches in the window about a station that is wide enough to tell them apart, a few degrees at most.
/// @param climbs  whether a surface that climbs along the shell is looked at over its climb
std::vector<FootCandidate> candidatesAt(const Foot& foot, std::size_t station, double half, const Tank& tank,
                                        bool climbs) {
  constexpr double kWidest = 5.0 * kPi / 180.0;  // half the arc that a sparse station may look at
  const FootScales& scales = foot.scales;
  const double near = scales.nearest(), direction = foot.directions[station], height = tank.foot(direction);
  for (;; half = std::min(1.6 * half, kWidest)) {
    auto points = foot.ring.around(direction, half, height, foot.reach);
    if (half < kWidest && !isFilled(points, scales, near)) continue;
    for (FootPoint& p : points) p.z -= tank.foot(direction + p.t / foot.radius) - height;
    if (climbs) flatten(points, scales);
    return findCandidates(points, scales, height - foot.reach);
  }
}

/// The elevation of a station's own points on the stretch that was chosen; the stretch's where they are few.
double guessAt(const std::vector<FootPoint>& points, const FootCandidate& chosen, double reach) {
  constexpr std::size_t kFew = 5;
  constexpr double kAbout = 0.02;  // of the reach: what is further off is another thing
  std::vector<double> heights;
  for (const FootPoint& p : points) {
    const double z = p.z - chosen.slope * p.d;
    if (p.d >= chosen.from && p.d <= chosen.to && std::abs(z - chosen.height) < kAbout * reach) heights.push_back(z);
  }
  return heights.size() < kFew ? chosen.height : median(heights);
}

/// Of a scan so noisy that surfaces at different heights cannot be told apart: the elevation of each station's points
/// nearest to the shell.
FootElevations nearestToShell(const Foot& foot) {
  constexpr std::size_t kFew = 5;
  const double near = foot.scales.nearest();
  std::vector<double> guesses(foot.directions.size(), kUnknown);
  forEachIndex(guesses.size(), 0, [&](std::size_t i) {
    std::vector<double> heights;
    for (double to = near + 0.1 * foot.reach; heights.size() < kFew && to < foot.reach; to += 0.1 * foot.reach) {
      heights.clear();
      for (const FootPoint& p : foot.points[i]) {
        if (p.d >= near && p.d <= to) heights.push_back(p.z);
      }
    }
    if (heights.size() >= kFew) guesses[i] = median(heights);
  });
  const std::vector<double> filled = filledUp(runningMedian(guesses, 3));
  return {filled, filled, std::vector<bool>(guesses.size(), true), 0.0};
}

/// The stretch that was chosen nearest to a station; null where none was.
const FootCandidate* nearestChosen(const std::vector<const FootCandidate*>& chosen, std::size_t station) {
  const std::size_t count = chosen.size();
  for (std::size_t away = 0; away <= count / 2; ++away) {
    for (const std::size_t i : {(station + away) % count, (station + count - away) % count})
      if (chosen[i] != nullptr) return chosen[i];
  }
  return nullptr;
}

/// The lowest surface of a station's own points below the level that its neighbours give; NaN where there is none.
double levelBelow(const Foot& foot, std::size_t station, double expected, const FootCandidate& like) {
  constexpr std::size_t kFew = 5;
  constexpr double kDeep = 0.2, kLayer = 0.02;  // of the reach
  std::vector<double> heights;
  for (const FootPoint& p : foot.points[station]) {
    const double z = p.z - like.slope * p.d;
    if (p.d >= like.from && p.d <= like.to && z < expected && z > expected - kDeep * foot.reach) heights.push_back(z);
  }
  if (heights.size() < kFew) return kUnknown;
  keepLowestLayer(heights, std::max(kLayer * foot.reach, 6.0 * foot.scales.shell_noise));
  return heights.size() < kFew ? kUnknown : median(heights);
}

/// Adds the levels of dips that a section over several degrees smears: in runs of stations where nothing was chosen,
/// the surface below the level that the neighbours give, where the shell is seen to go down to it. (What lies above
/// that level may be soil.)
/// @param chosen  the stretch of every station, null where there is none
void addDips(const Foot& foot, const std::vector<const FootCandidate*>& chosen, std::vector<double>& guesses) {
  constexpr std::size_t kLongest = 6;  // longer parts of the ring are no dips
  const std::size_t count = guesses.size();
  const std::vector<double> expected = filledUp(guesses);
  std::vector<char> unknown(count);
  for (std::size_t i = 0; i < count; ++i) unknown[i] = chosen[i] == nullptr ? 1 : 0;
  std::vector<double> found = guesses;
  for (std::size_t i = 0; i < count; ++i) {
    const FootCandidate* like = unknown[i] != 0 ? nearestChosen(chosen, i) : nullptr;
    if (like != nullptr && foot.shell_seen[i]) found[i] = levelBelow(foot, i, expected[i], *like);
  }
  const std::vector<double> deep = filledUp(found);  // where a row of points misses a station, the shell may be seen
  for (const RingRun& run : runsRound(unknown)) {
    if (run.last - run.first >= count / kLongest) continue;
    ShellCounts shell;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      const std::size_t i = k % count;
      if (foot.shell_seen[i]) shell.add(countShell(foot, i, levelAt(foot, expected[i], 0.0), expected[i] - deep[i]));
    }
    if (!shell.isGoodPart()) continue;  // a surface is seen as well, so that few points of the shell will do
    for (std::size_t k = run.first; k <= run.last; ++k) guesses[k % count] = found[k % count];
  }
}

/// The elevation of every station whose place has a stretch that the shell stands on; NaN elsewhere.
/// @param left_out  stations that are not looked at; may be empty
std::vector<double> guessRoundRing(const Foot& foot, const Tank& tank, const std::vector<bool>& left_out) {
  constexpr std::size_t kMostPlaces = 360;
  const std::size_t count = foot.directions.size(), stride = (count + kMostPlaces - 1) / kMostPlaces;
  const std::size_t places = (count + stride - 1) / stride;
  const double half = foot.half_step * static_cast<double>(stride), arc = foot.arc() * static_cast<double>(stride);
  std::vector<std::vector<FootCandidate>> candidates(places);
  const auto look_at = [&](std::size_t k, bool climbs) {
    if (!left_out.empty() && left_out[k * stride]) return;
    candidates[k] = candidatesAt(foot, k * stride, half, tank, climbs);
  };
  forEachIndex(places, 0, [&](std::size_t k) { look_at(k, false); });
  std::vector<bool> between;
  auto choice = chooseRoundRing(candidates, arc, foot.reach, &between);
  if (foot.inside && !between.empty()) {  // a floor may go on from one level to the other, as soil does outside
    forEachIndex(places, 0, [&](std::size_t k) {
      if (between[k]) look_at(k, true);
    });
    choice = chooseRoundRing(candidates, arc, foot.reach);
  }
  std::vector<double> guesses(count, kUnknown);
  std::vector<const FootCandidate*> chosen(count, nullptr);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = std::min(places - 1, i / stride);
    if (!choice[k]) continue;
    chosen[i] = &candidates[k][*choice[k]];
    guesses[i] = guessAt(foot.points[i], *chosen[i], foot.reach);
  }
  addDips(foot, chosen, guesses);
  return guesses;
}

}  // namespace

std::vector<bool> closeTo(const Foot& foot, const std::vector<double>& elevations) {
  constexpr double kClose = 3.0 * kPi / 180.0;
  const std::size_t count = elevations.size(), close = foot.stationsBeside(kClose);
  std::vector<bool> near(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(elevations[i])) continue;
    for (std::size_t k = i + count - close; k <= i + count + close; ++k) near[k % count] = true;
  }
  return near;
}

bool isResolved(const Foot& foot) { return foot.scales.shell_noise <= kResolved * foot.reach; }

FootElevations firstElevations(const Foot& foot, const Tank& tank, const std::vector<bool>& left_out) {
  if (!isResolved(foot)) return nearestToShell(foot);
  FootElevations first;
  first.known = guessRoundRing(foot, tank, left_out);
  first.seen = closeTo(foot, first.known);
  first.filled = filledUp(runningMedian(first.known, 3));
  for (std::size_t i = 0; i < first.known.size(); ++i) {
    if (std::isfinite(first.known[i])) first.known[i] = first.filled[i];
  }
  return first;
}

}  // namespace tank_datum
