#include "locate/nested_tanks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "locate/step_back.h"
#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

/// Whether the stretches of height over which two shells are seen are mostly the same; a ringwall ends where its shell
/// begins.
bool standAtOneHeight(const Tank& a, const Tank& b) {
  const double foot_a = a.foot.coefficients[0], foot_b = b.foot.coefficients[0];
  const double shared = std::min(foot_a + a.height, foot_b + b.height) - std::max(foot_a, foot_b);
  return shared > 0.5 * std::min(a.height, b.height);
}

/// Whether one is the face upon which the other stands, or face and shell taken for one wall.
bool isRingwallOf(const Tank& face, const Tank& shell) {
  if (!shell.standsOnRingwall() || face.standsOnRingwall()) return false;
  return face.foot.coefficients[0] < shell.foot.coefficients[0] - 0.5 * shell.ringwall_height;
}

/// The larger circle and the smaller one, and how far they are apart.
struct Nested {
  const Tank &outer, &inner;
  double apart;  ///< of the centres [m]

  Nested(const Tank& a, const Tank& b)
      : outer(a.circle.radius >= b.circle.radius ? a : b),
        inner(&outer == &a ? b : a),
        apart((outer.circle.center - inner.circle.center).norm()) {}
  /// How far one is from the other at most [m].
  double gap() const { return apart + outer.circle.radius - inner.circle.radius; }
};

/// Whether two circles are one shell: found on two rungs, or again from what its tolerance left over.
bool areOneShell(const Tank& a, const Tank& b) {
  if (!a.foot.valid() || !b.foot.valid()) return false;
  const Nested two(a, b);
  if (two.gap() <= kRingwallWidth && (isRingwallOf(a, b) || isRingwallOf(b, a))) return false;
  const double same = std::max(4.0 * two.outer.resolution, 0.02 * two.outer.circle.radius);
  return two.gap() <= same && standAtOneHeight(a, b);
}

using Tanks = std::vector<Tank>::iterator;

/// Of one shell, found several times: among those that show a foundation beside it, if any does, the finest that shows
/// nearly as much of the shell as any, of two on one rung the smaller: what stands before a shell makes its circle
/// larger.
Tanks bestOf(Tanks first, Tanks last) {
  constexpr double kMuchMore = 1.25;  // arc seen on a coarser rung that outweighs the finer rung's accuracy
  const auto has_foundation = [](const Tank& tank) { return tank.has_foundation; };
  last = std::any_of(first, last, has_foundation) ? std::stable_partition(first, last, has_foundation) : last;
  const auto less = [](const Tank& a, const Tank& b) { return a.coverage < b.coverage; };
  const double most = std::max_element(first, last, less)->coverage;
  last = std::stable_partition(first, last, [&](const Tank& tank) { return kMuchMore * tank.coverage >= most; });
  return std::min_element(first, last, [](const Tank& a, const Tank& b) {
    return std::pair(a.resolution, a.circle.radius) < std::pair(b.resolution, b.circle.radius);
  });
}

/// Leaves one circle of each shell.
void dropRepeated(std::vector<Tank>& tanks) {
  for (std::size_t i = 0; i < tanks.size();) {
    const Tanks tank = tanks.begin() + static_cast<std::ptrdiff_t>(i);
    const Tanks others =
        std::stable_partition(tank + 1, tanks.end(), [&](const Tank& other) { return areOneShell(*tank, other); });
    if (others == tank + 1) {
      ++i;
      continue;
    }
    std::iter_swap(tank, bestOf(tank, others));
    tanks.erase(tank + 1, others);
  }
}

/// Whether the outer one is a wall round the inner one, however much of either a scan shows: the inner one is seen from
/// outside upon a foundation, and the outer one from within, or it is no higher than a ringwall and ends lower than the
/// other begins. What stands inside of a tank, or upon its roof, is smaller.
bool isWallRound(const Tank& outer, const Tank& inner) {
  constexpr double kOfTank = 0.15;   // of the outer radius, that columns inside of a tank do not have
  constexpr double kOfPlinth = 0.5;  // that what stands on a low tank's roof does not have
  constexpr double kAsHigh = 0.5;    // of the outer height, that of things inside of a tank mostly is less
  if (inner.side != Side::Outside || !inner.has_foundation) return false;
  const double share = inner.circle.radius / outer.circle.radius;
  if (outer.side == Side::Inside) return share >= kOfTank && inner.height >= kAsHigh * outer.height;
  return share >= kOfPlinth && outer.height <= kHighestRingwall &&
         outer.foot.coefficients[0] < inner.foot.coefficients[0];
}

/// The one of two nested circles that is no tank, or null when both may be.
const Tank* falseCircleOf(const Tank& a, const Tank& b) {
  const Nested two(a, b);
  if (two.apart > two.outer.circle.radius || !a.foot.valid() || !b.foot.valid()) return nullptr;
  if (two.gap() <= kRingwallWidth) {
    if (isRingwallOf(a, b)) return &a;
    if (isRingwallOf(b, a)) return &b;
    if (two.outer.foot.coefficients[0] < two.inner.foot.coefficients[0]) return &two.outer;
  }
  if (isWallRound(two.outer, two.inner)) return &two.outer;
  return two.outer.height < two.inner.height ? &two.outer : &two.inner;  // a bund round a tank, or a thing inside one
}

}  // namespace

void dropNested(std::vector<Tank>& tanks) {
  dropRepeated(tanks);
  for (std::size_t i = 0; i < tanks.size(); ++i) {
    for (std::size_t j = i + 1; j < tanks.size();) {
      const Tank* out = falseCircleOf(tanks[i], tanks[j]);
      if (!out) {
        ++j;
        continue;
      }
      if (out == &tanks[i]) std::swap(tanks[i], tanks[j]);
      tanks.erase(tanks.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
}

}  // namespace tank_datum
