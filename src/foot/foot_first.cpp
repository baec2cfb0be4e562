#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "foot/foot_choice.h"
#include "foot/foot_profile.h"
#include "foot/foot_state.h"
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

/// The stretches in the window about a station that is wide enough to tell them apart, a few degrees at most.
std::vector<FootCandidate> candidatesAt(const Foot& foot, std::size_t station, double half, const Tank& tank) {
  constexpr double kWidest = 5.0 * kPi / 180.0;  // half the arc that a sparse station may look at
  const FootScales& scales = foot.scales;
  const double near = scales.nearest(), direction = foot.directions[station], height = tank.foot(direction);
  for (;; half = std::min(1.6 * half, kWidest)) {
    auto points = foot.ring.around(direction, half, height, foot.reach);
    for (FootPoint& p : points) p.z -= tank.foot(direction + p.t / foot.radius) - height;
    if (half >= kWidest || isFilled(points, scales, near)) return findCandidates(points, scales);
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

/// Stations within a few degrees of one where a stretch was chosen.
std::vector<bool> closeTo(const std::vector<double>& datum, double step) {
  constexpr double kClose = 3.0 * kPi / 180.0;
  const auto count = static_cast<std::ptrdiff_t>(datum.size());
  const auto reach = std::max<std::ptrdiff_t>(1, std::lround(kClose / step));
  std::vector<bool> close(datum.size(), false);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (!std::isfinite(datum[static_cast<std::size_t>(i)])) continue;
    for (std::ptrdiff_t j = i - reach; j <= i + reach; ++j) close[static_cast<std::size_t>((j + count) % count)] = true;
  }
  return close;
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
  return {filled, filled, std::vector<bool>(guesses.size(), true)};
}

/// The elevation of every station whose place has a stretch that the shell stands on; NaN elsewhere.
std::vector<double> guessRoundRing(const Foot& foot, const Tank& tank) {
  constexpr std::size_t kMostPlaces = 360;
  const std::size_t count = foot.directions.size(), stride = (count + kMostPlaces - 1) / kMostPlaces;
  const std::size_t places = (count + stride - 1) / stride;
  std::vector<std::vector<FootCandidate>> candidates(places);
  forEachIndex(places, 0, [&](std::size_t k) {
    candidates[k] = candidatesAt(foot, k * stride, foot.half_step * static_cast<double>(stride), tank);
  });
  const double arc = 2.0 * foot.half_step * foot.radius * static_cast<double>(stride);
  const auto choice = chooseRoundRing(candidates, arc, foot.reach);
  std::vector<double> guesses(count, kUnknown);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = std::min(places - 1, i / stride);
    if (!choice[k]) continue;
    guesses[i] = guessAt(foot.points[i], candidates[k][*choice[k]], foot.reach);
  }
  return guesses;
}

}  // namespace

bool isResolved(const Foot& foot) {
  constexpr double kResolved = 0.01;  // noise over the reach of the section; a lip and its ringwall are 0.02 apart
  return foot.scales.shell_noise <= kResolved * foot.reach;
}

FootElevations firstElevations(const Foot& foot, const Tank& tank) {
  if (!isResolved(foot)) return nearestToShell(foot);
  FootElevations first;
  first.known = guessRoundRing(foot, tank);
  first.seen = closeTo(first.known, 2.0 * foot.half_step);
  first.filled = filledUp(runningMedian(first.known, 3));
  for (std::size_t i = 0; i < first.known.size(); ++i) {
    if (std::isfinite(first.known[i])) first.known[i] = first.filled[i];
  }
  return first;
}

}  // namespace tank_datum
