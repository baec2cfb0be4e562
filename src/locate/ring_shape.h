#pragma once

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

constexpr double kAboveFoot = 0.3;  ///< of the reach: from so high above the foot on nothing but the shell is seen

/// How far about a tank's foot is looked at where so much is asked for [m].
inline double reachOf(const Tank& tank, double asked) { return std::min(asked, 0.5 * tank.circle.radius); }

/// Which points lie near the foot.
struct RingShape {
  Circle circle;
  double reach, slope_x, slope_y, height;
  double inner, outer;  ///< squared radii [m2]

  RingShape(const Tank& tank, double reach_of_ring)
      : circle(tank.circle),
        reach(reach_of_ring),
        slope_x(tank.foot.coefficients[1] / tank.circle.radius),
        slope_y(tank.foot.coefficients[2] / tank.circle.radius),
        height(tank.foot.coefficients[0]),
        inner(square(std::max(0.0, circle.radius - reach))),
        outer(square(circle.radius + reach)) {}

  bool holds(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    const double squared = arm.squaredNorm();
    if (squared < inner || squared > outer) return false;
    return std::abs(p.z() - (height + slope_x * arm.x() + slope_y * arm.y())) <= reach;
  }
};

}  // namespace tank_datum
