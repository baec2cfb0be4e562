#include "locate/wall_sector.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kFewest = 3.0;  // voxels that a wall is high

/// The line off = at + lean * z of an upright wall, from the medians of its middle and upper third: its lowest third
/// may be another's.
struct WallLine {
  double at, lean;

  explicit WallLine(const std::vector<Hit>& run) {
    const std::size_t third = run.size() / 3;
    const auto middle = [&](std::size_t from, std::size_t to, double Hit::*value) {
      std::vector<double> values;
      for (std::size_t i = from; i < to; ++i) values.push_back(run[i].*value);
      return median(values);
    };
    const double z = middle(third, 2 * third, &Hit::z), off = middle(third, 2 * third, &Hit::off);
    const double upper_z = middle(2 * third, run.size(), &Hit::z);
    lean = upper_z > z ? (middle(2 * third, run.size(), &Hit::off) - off) / (upper_z - z) : 0.0;
    at = off - lean * z;
  }
  double from(const Hit& hit) const { return std::abs(hit.off - at - lean * hit.z); }
};

/// The longest stretch of heights without a hole.
std::vector<Hit> longestRun(std::vector<Hit> hits, double voxel) {
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.z < b.z; });
  std::size_t best_first = 0, best_last = 0;
  for (std::size_t first = 0, last = 0; first < hits.size(); first = last + 1) {
    last = first;
    while (last + 1 < hits.size() && hits[last + 1].z - hits[last].z <= 3.0 * voxel) ++last;
    if (hits[last].z - hits[first].z > hits[best_last].z - hits[best_first].z) {
      best_first = first;
      best_last = last;
    }
  }
  if (hits.empty()) return {};
  return {hits.begin() + static_cast<std::ptrdiff_t>(best_first),
          hits.begin() + static_cast<std::ptrdiff_t>(best_last) + 1};
}

/// A piece of a wall: means, and sums of squares and products about them.
struct Piece {
  double n = 0, z = 0, off = 0, zz = 0, zo = 0;

  void add(const Hit& hit) {
    n += 1.0;
    const double from_z = hit.z - z;
    z += from_z / n, off += (hit.off - off) / n;
    zz += from_z * (hit.z - z), zo += from_z * (hit.off - off);
  }
};

/// A wall in two pieces that lean alike, as far above a height as it reaches below it.
struct TwoPieces {
  double apart = 0;    ///< how far the lower one stands out [m]
  double scatter = 0;  ///< mean of what hits are off their piece [m]

  /// @param run  sorted by height
  TwoPieces(const std::vector<Hit>& run, double height, double voxel) {
    const double end = height + std::max(height - run.front().z, kFewest * voxel);
    Piece lower, upper;
    for (const Hit& hit : run) {
      if (hit.z <= end) (hit.z < height ? lower : upper).add(hit);
    }
    const double squares = lower.zz + upper.zz, lean = squares > 0.0 ? (lower.zo + upper.zo) / squares : 0.0;
    apart = lower.off - upper.off - lean * (lower.z - upper.z);
    for (const Hit& hit : run) {
      const Piece& piece = hit.z < height ? lower : upper;
      if (hit.z <= end) scatter += std::abs(hit.off - piece.off - lean * (hit.z - piece.z));
    }
    scatter /= lower.n + upper.n;
  }
};

}  // namespace

std::vector<Sector> sectorsOf(const Points& points, double voxel, const Circle& circle, double band) {
  constexpr double kWithinRingwall = 0.1;  // on top of the narrowest ringwall or plate beside the shell [m]
  const double reach = std::max(0.1 * circle.radius, 6.0 * voxel),
               clear = std::min(0.5 * reach, std::max(kWithinRingwall, 3.0 * voxel));
  const double count = std::clamp(std::floor(kTwoPi * circle.radius / (3.0 * voxel)), 24.0, 180.0);
  std::vector<Sector> sectors(static_cast<std::size_t>(count));
  for (const auto& p : points) {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    const double off = arm.norm() - circle.radius;
    if (std::abs(off) > band + reach) continue;
    const double turn = portable::atan2(arm.y(), arm.x()) / kTwoPi;
    auto& sector = sectors[static_cast<std::size_t>((turn - std::floor(turn)) * count) % sectors.size()];
    if (std::abs(off) <= band) sector.shell.push_back({p.z(), off});
    if (std::abs(off) > band + clear) (off > 0 ? sector.outside : sector.inside).push_back(p.z());
  }
  return sectors;
}

bool shellRun(const std::vector<Hit>& hits, double voxel, double thickness, double& bottom, double& top) {
  std::vector<Hit> run = longestRun(hits, voxel);
  if (run.size() < 3) return false;
  const WallLine line(run);
  run.erase(std::remove_if(run.begin(), run.end(), [&](const Hit& hit) { return line.from(hit) > thickness; }),
            run.end());
  run = longestRun(std::move(run), voxel);
  if (run.empty()) return false;
  bottom = run.front().z;
  top = run.back().z;
  return top - bottom >= kFewest * voxel;
}

double stepBackHeight(const std::vector<Hit>& hits, double voxel, double least) {
  constexpr double kHighest = 2.0;  // ringwalls stand out of the ground by no more [m]
  constexpr double kClear = 0.2;    // of what the pieces are apart: a wall that leans or bends has no step
  const std::vector<Hit> run = longestRun(hits, voxel);
  if (run.empty()) return kUnknown;
  const double bottom = run.front().z, top = run.back().z, piece = kFewest * voxel;
  double best = kUnknown, scatter = HUGE_VAL;
  for (double height = bottom + piece; height <= std::min(bottom + kHighest, top - piece); height += 0.5 * voxel) {
    const TwoPieces pieces(run, height, voxel);
    if (pieces.apart <= least || pieces.scatter > std::min(scatter, kClear * pieces.apart)) continue;
    scatter = pieces.scatter;
    best = height;
  }
  return best;
}

bool hasFoundation(const std::vector<double>& beside, double foot, double voxel, double radius) {
  constexpr double kDeepestDrop = 0.5;  // ground below the shell foot at a ringwall or pad shoulder [m]
  const double drop = std::min(kDeepestDrop, 0.25 * radius) + 4.0 * voxel, rise = 0.02 * radius + 4.0 * voxel;
  return std::any_of(beside.begin(), beside.end(), [&](double z) { return z > foot - drop && z < foot + rise; });
}

}  // namespace tank_datum
