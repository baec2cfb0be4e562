#pragma once

#include <cstddef>
#include <vector>

#include "locate/wall_map.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {

constexpr double kFacing = 0.94;  ///< cosine of 20 degrees between a wall's normal and the direction to the centre

/// Whether a wall stands on a circle: near it, and its normal points to the centre within an angle.
struct StandingRule {
  double tolerance;  ///< distance from the circle [m]
  double facing;     ///< cosine of the angle

  bool holds(const WallCell& wall, const Circle& circle) const;
};

/// The arcs of circles on which walls stand [rad], in bins two wall cells long: a full circle is 2 pi exactly.
class ArcMeter {
 public:
  explicit ArcMeter(const std::vector<const WallCell*>& walls);

  /// @param bin_length  roughly [m]
  double seen(const Circle& circle, const StandingRule& rule, double bin_length);

 private:
  std::size_t count_;
  std::vector<double> x_, y_, normal_x_, normal_y_;  // each with room for whole lanes
  std::vector<char> seen_;
};

}  // namespace tank_datum
