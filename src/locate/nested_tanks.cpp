#include "locate/nested_tanks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

constexpr double kMuchMore = 1.25;  // arc seen on a coarser rung that outweighs the finer rung's accuracy

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

/// The one of two nested circles that is no tank, or null when both may be.
const Tank* falseCircleOf(const Tank& a, const Tank& b) {
  const Tank& outer = a.circle.radius >= b.circle.radius ? a : b;
  const Tank& inner = &outer == &a ? b : a;
  const double apart = (outer.circle.center - inner.circle.center).norm();
  if (apart > outer.circle.radius || !a.foot.valid() || !b.foot.valid()) return nullptr;
  const double gap = outer.circle.radius - inner.circle.radius;
  if (apart + gap <= kRingwallWidth && isRingwallOf(a, b)) return &a;
  if (apart + gap <= kRingwallWidth && isRingwallOf(b, a)) return &b;
  const double same = std::max(4.0 * outer.resolution, 0.02 * outer.circle.radius);
  if (apart + gap <= same && standAtOneHeight(outer, inner)) {
    // one shell found twice: on two rungs, or again from what its tolerance left over
    const Tank& finer = outer.resolution < inner.resolution ? outer : inner;
    const Tank& coarser = &finer == &outer ? inner : outer;
    return coarser.coverage > kMuchMore * finer.coverage ? &finer : &coarser;
  }
  if (apart + gap <= kRingwallWidth && outer.foot.coefficients[0] < inner.foot.coefficients[0]) return &outer;
  return outer.height < inner.height ? &outer : &inner;  // a bund wall round a tank, or a thing inside a tank
}

}  // namespace

void dropNested(std::vector<Tank>& tanks) {
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
