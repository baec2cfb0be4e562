#include "locate/wall_sector.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// A line off = at + lean * z.
struct WallLine {
  double at, lean;

  double from(const Hit& hit) const { return std::abs(hit.off - at - lean * hit.z); }
};

/// The line of an upright wall, from the medians of its middle and upper third: its lowest third may be another's.
/// Under a dome, which leans and the wall below it does not, from those of its lowest and middle third.
WallLine lineOf(const std::vector<Hit>& run) {
  constexpr double kLeans = 0.05;  // more than a shell does [m/m]
  const std::size_t third = run.size() / 3;
  const auto middle = [&](std::size_t from, std::size_t to, double Hit::*value) {
    std::vector<double> values;
    for (std::size_t i = from; i < to; ++i) values.push_back(run[i].*value);
    return median(values);
  };
  const double z = middle(third, 2 * third, &Hit::z), off = middle(third, 2 * third, &Hit::off);
  const auto leanTo = [&](std::size_t from, std::size_t to) {
    const double rise = middle(from, to, &Hit::z) - z;
    return rise != 0.0 ? (middle(from, to, &Hit::off) - off) / rise : 0.0;
  };
  const double upper = leanTo(2 * third, run.size()), lower = leanTo(0, third);
  const double lean = std::abs(upper) > kLeans && std::abs(lower) < 0.5 * std::abs(upper) ? lower : upper;
  return {off - lean * z, lean};
}

/// The first and the last of hits without a hole between them.
struct Stretch {
  std::size_t first, last;
};

/// All stretches, from the lowest on.
/// @param hits  by height
std::vector<Stretch> runsOf(const std::vector<Hit>& hits, double hole) {
  std::vector<Stretch> runs;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (i == 0 || hits[i].z - hits[i - 1].z > hole) runs.push_back({i, i});
    runs.back().last = i;
  }
  return runs;
}

/// Where a wall ends below that goes on under a hole, as what a girder or a ring about a shell hides is one: runs below
/// count that are no shorter than the hole above them.
/// @param hits    on the wall's line, by height
/// @param bottom  of its longest run [m]
double bottomUnderHoles(const std::vector<Hit>& hits, double bottom, double voxel) {
  const std::vector<Stretch> runs = runsOf(hits, kHoleInVoxels * voxel);
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    const double top = hits[run->last].z, low = hits[run->first].z;
    if (top < bottom && bottom - top <= top - low) bottom = low;
  }
  return bottom;
}

}  // namespace

std::vector<Sector> sectorsOf(const Points& points, double voxel, const Circle& circle, double band) {
  constexpr double kOfRadius = 0.2;        // on smaller things nothing is as wide
  constexpr double kWithinRingwall = 0.1;  // on top of the narrowest ringwall or plate beside the shell [m]
  const double reach = std::max(0.1 * circle.radius, 6.0 * voxel),
               clear = std::min(0.5 * reach, std::max(kWithinRingwall, 3.0 * voxel));
  const double around = std::max(band, std::min(kRingwallWidth, kOfRadius * circle.radius));
  const double count = std::clamp(std::floor(kTwoPi * circle.radius / (3.0 * voxel)), 24.0, 180.0);
  std::vector<Sector> sectors(static_cast<std::size_t>(count));
  for (const auto& p : points) {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    const double off = arm.norm() - circle.radius;
    if (off > std::max(band + reach, around) || off < -(around + reach)) continue;
    const double turn = portable::atan2(arm.y(), arm.x()) / kTwoPi;
    auto& sector = sectors[static_cast<std::size_t>((turn - std::floor(turn)) * count) % sectors.size()];
    if (std::abs(off) <= band) sector.shell.push_back({p.z(), off});
    if (std::abs(off) <= around) sector.around.push_back({p.z(), off});
    if (off < -around) sector.farther_in.push_back(p.z());
    if (std::abs(off) <= band + clear || std::abs(off) > band + reach) continue;
    (off > 0 ? sector.outside : sector.inside).push_back(p.z());
  }
  return sectors;
}

void sortByHeight(std::vector<Hit>& hits) {
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.z < b.z; });
}

std::vector<Hit> longestRun(const std::vector<Hit>& hits, double hole) {
  if (hits.empty()) return {};
  const std::vector<Stretch> runs = runsOf(hits, hole);
  const auto length = [&](const Stretch& run) { return hits[run.last].z - hits[run.first].z; };
  const auto longest = std::max_element(runs.begin(), runs.end(),
                                        [&](const Stretch& a, const Stretch& b) { return length(a) < length(b); });
  return {hits.begin() + static_cast<std::ptrdiff_t>(longest->first),
          hits.begin() + static_cast<std::ptrdiff_t>(longest->last) + 1};
}

std::optional<WallRun> shellRun(std::vector<Hit> hits, double voxel, double thickness) {
  sortByHeight(hits);
  std::vector<Hit> run = longestRun(hits, kHoleInVoxels * voxel);
  if (run.size() < 3) return std::nullopt;
  const WallLine line = lineOf(run);
  const auto dropOthers = [&](std::vector<Hit>& of) {
    of.erase(std::remove_if(of.begin(), of.end(), [&](const Hit& hit) { return line.from(hit) > thickness; }),
             of.end());
  };
  dropOthers(run), dropOthers(hits);
  run = longestRun(run, kHoleInVoxels * voxel);
  if (run.empty() || run.back().z - run.front().z < kFewestVoxels * voxel) return std::nullopt;
  return WallRun{run.front().z, run.back().z, bottomUnderHoles(hits, run.front().z, voxel)};
}

bool hasFoundation(const std::vector<double>& beside, double foot, double voxel, double radius) {
  constexpr double kDeepestDrop = 0.5;  // ground below the shell foot at a ringwall or pad shoulder [m]
  const double drop = std::min(kDeepestDrop, 0.25 * radius) + 4.0 * voxel, rise = 0.02 * radius + 4.0 * voxel;
  return std::any_of(beside.begin(), beside.end(), [&](double z) { return z > foot - drop && z < foot + rise; });
}

}  // namespace tank_datum
