#include "locate/arc_meter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/cpu_dispatch.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kLanes = 4;

using Doubles = double __attribute__((vector_size(8 * kLanes)));
using Indices = std::int32_t __attribute__((vector_size(4 * kLanes)));

struct WallColumns {
  const double *x, *y, *normal_x, *normal_y;
  std::size_t count;  ///< in whole lanes; what fills them up is not a number
};

/// The rule by squares.
struct Squares {
  double inner, outer, facing;
};

/// Marks the bins, of so many to a turn, in which walls stand; the one after the last is for those that do not.
TANK_DATUM_CPU_DISPATCH
void markStanding(const WallColumns& walls, const double* center, const Squares& squares, std::int32_t bins,
                  char* seen) {
  for (std::size_t begin = 0; begin < walls.count; begin += kLanes) {
    Doubles x, y, normal_x, normal_y;
    std::memcpy(&x, walls.x + begin, sizeof x);
    std::memcpy(&y, walls.y + begin, sizeof y);
    std::memcpy(&normal_x, walls.normal_x + begin, sizeof normal_x);
    std::memcpy(&normal_y, walls.normal_y + begin, sizeof normal_y);
    x -= center[0];
    y -= center[1];
    const Doubles squared = x * x + y * y, facing = normal_x * x + normal_y * y;
    const auto stands =
        (squared >= squares.inner) & (squared <= squares.outer) & (facing * facing >= squares.facing * squared);
    if ((stands[0] | stands[1] | stands[2] | stands[3]) == 0) continue;
    // approxTurn of four places
    const Doubles along = x < 0.0 ? -x : x, across = y < 0.0 ? -y : y;
    const Doubles larger = along > across ? along : across, smaller = along > across ? across : along;
    const Doubles z = smaller / (larger > 0.0 ? larger : 1.0), s = z * z;
    const Doubles octant = z * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
    const Doubles quadrant = across > along ? 0.5 * kPi - octant : octant;
    const Doubles half = x < 0.0 ? kPi - quadrant : quadrant;
    const Doubles turn = (y < 0.0 ? kTwoPi - half : half) / kTwoPi;
    const Doubles place = (turn < 1.0 ? turn : 0.0) * static_cast<double>(bins);
    std::int32_t at[kLanes];
    const Indices bin = __builtin_convertvector(stands ? place : static_cast<double>(bins), Indices);
    std::memcpy(at, &bin, sizeof at);
    for (const std::int32_t i : at) seen[i] = 1;
  }
}

}  // namespace

bool StandingRule::holds(const WallCell& wall, const Circle& circle) const {
  const Eigen::Vector2d arm = wall.position - circle.center;
  const double distance = arm.norm();
  return std::abs(distance - circle.radius) <= tolerance && std::abs(wall.normal.dot(arm)) >= facing * distance;
}

ArcMeter::ArcMeter(const std::vector<const WallCell*>& walls) : count_((walls.size() + kLanes - 1) / kLanes * kLanes) {
  for (auto* column : {&x_, &y_, &normal_x_, &normal_y_}) {
    column->assign(count_, std::numeric_limits<double>::quiet_NaN());
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    x_[i] = walls[i]->position.x();
    y_[i] = walls[i]->position.y();
    normal_x_[i] = walls[i]->normal.x();
    normal_y_[i] = walls[i]->normal.y();
  }
}

double ArcMeter::seen(const Circle& circle, const StandingRule& rule, double bin_length) {
  const double bins = std::clamp(std::floor(kTwoPi * circle.radius / bin_length), 18.0, 180.0);
  const auto count = static_cast<std::int32_t>(bins);
  seen_.assign(static_cast<std::size_t>(count) + 1, 0);
  const double inner = std::max(0.0, circle.radius - rule.tolerance), outer = circle.radius + rule.tolerance;
  markStanding({x_.data(), y_.data(), normal_x_.data(), normal_y_.data(), count_}, circle.center.data(),
               {inner * inner, outer * outer, rule.facing * rule.facing}, count, seen_.data());
  return kTwoPi * (static_cast<double>(std::count(seen_.begin(), seen_.end() - 1, 1)) / bins);
}

}  // namespace tank_datum
