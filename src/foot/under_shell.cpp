#include "foot/under_shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/parallel.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kCells = 50;  // of height over the levels, up to the reach
constexpr double kAbout = 0.04;     // of the reach: about the foundation
constexpr double kFrom = 0.2;       // of the reach, up to which cladding may leave the shell in sight
constexpr double kPart = 0.25;      // of what is seen before the shell
constexpr std::size_t kFewest = 5;  // points before it

/// What is seen at a wall: the foundation before and behind it, and by height the wall, what is behind it, and what is
/// so far behind that it is no part of the wall.
struct WallCounts {
  std::size_t before = 0, behind = 0, floor = 0;
  std::array<std::size_t, kCells> wall{}, past{}, beyond{};

  void add(const WallCounts& other) {
    before += other.before, behind += other.behind, floor += other.floor;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      wall[cell] += other.wall[cell], past[cell] += other.past[cell], beyond[cell] += other.beyond[cell];
    }
  }
  double part() const { return kPart * static_cast<double>(before); }
};

/// The cell above the highest hole in a wall; 0 where it has none.
std::size_t aboveHole(const std::array<std::size_t, kCells>& wall) {
  constexpr std::size_t kHole = 5;  // empty cells
  constexpr double kStrays = 0.05;  // of what the fullest holds
  const double least = kStrays * static_cast<double>(*std::max_element(wall.begin(), wall.end()));
  std::size_t above = kCells, empty = 0;
  for (std::size_t cell = kCells; cell-- > 0;) {
    if (static_cast<double>(wall[cell]) > least) {
      above = cell, empty = 0;
    } else if (above < kCells && ++empty == kHole) {
      return above;
    }
  }
  return 0;
}

/// Whether the foundation goes on under a wall, or what is below a hole in it; nothing where that is not told.
enum class Under { NotTold, No, Yes };

Under underOf(const WallCounts& counts) {
  const std::size_t above = aboveHole(counts.wall);
  const auto from = std::max(above, static_cast<std::size_t>(std::lround(kFrom * kCells)));
  std::size_t through = counts.floor, behind = above > 0 ? 0 : counts.behind;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    if (cell >= from) through += counts.beyond[cell];
    if (cell < above) behind += counts.past[cell];
  }
  if (counts.before < kFewest || static_cast<double>(through) >= counts.part()) return Under::NotTold;
  return static_cast<double>(behind) >= counts.part() ? Under::Yes : Under::No;
}

}  // namespace

bool UnderShell::isOfFew() const {
  constexpr double kFew = 0.25;
  return share <= kFew;
}

UnderShell findUnderShell(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<double>& levels) {
  constexpr double kArc = 3.0 * kDegree;  // to either side, that is looked at together
  constexpr double kBeside = 0.1;         // of the reach: before the shell
  constexpr double kThick = 0.4;          // of the reach: farther in than that there is a floor
  const std::size_t count = fits.size(), near = foot.stationsBeside(kArc);
  const double clear = foot.scales.nearest(), far = kBeside * foot.reach, about = kAbout * foot.reach;
  const auto cellOf = [&](double height) -> std::optional<std::size_t> {
    const double cell = height / foot.reach * kCells;
    return cell >= 0.0 && cell < kCells ? std::optional(static_cast<std::size_t>(cell)) : std::nullopt;
  };
  std::vector<WallCounts> own(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    WallCounts& counts = own[i];
    foot.ring.visitAround(foot.directions[i], foot.half_step, levels[i], foot.reach, [&](const FootPoint& p) {
      const double height = p.z - levels[i];
      const bool low = std::abs(height) < about;
      counts.before += low && p.d > clear && p.d < far;
      counts.behind += low && p.d < -clear;
      if (const auto cell = cellOf(height)) {
        counts.wall[*cell] += std::abs(p.d) <= clear;
        counts.past[*cell] += p.d < -clear;
      }
    });
    foot.ring.visitBehind(foot.directions[i], foot.half_step, levels[i], foot.reach, [&](const FootPoint& p) {
      const double height = p.z - levels[i];
      const bool is_floor = p.d < -kThick * foot.reach;
      counts.floor += is_floor && std::abs(height) < about;
      const auto cell = cellOf(height);
      if (is_floor || !cell) return;
      ++counts.past[*cell];
      ++counts.beyond[*cell];
    });
  });
  UnderShell found;
  found.seen.assign(count, false);
  std::size_t told = 0, under = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!fits[i].valid()) continue;
    WallCounts arc;
    for (std::size_t k = i + count - near; k <= i + count + near; ++k) arc.add(own[k % count]);
    const Under together = underOf(arc);
    if (together == Under::NotTold) continue;
    found.seen[i] = together == Under::Yes || underOf(own[i]) == Under::Yes;
    ++told;
    under += found.seen[i] ? 1 : 0;
  }
  if (told > 0) found.share = static_cast<double>(under) / static_cast<double>(told);
  return found;
}

}  // namespace tank_datum
