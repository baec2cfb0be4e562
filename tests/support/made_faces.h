#pragma once

#include <cmath>

#include "core/units.h"
#include "locate/wall_sector.h"

/// Points of walls about the origin and of the ground beside them.
namespace tank_datum::made_faces {

inline constexpr double kRadius = 10.0;

/// Adds an upright face all round, `off` outside of the circle, at every 0.06 m of height and of the way round.
inline void addFace(Points& points, double off, double from, double to) {
  for (double a = 0.0; a < kTwoPi; a += 0.006) {
    for (double z = from; z <= to; z += 0.06) {
      points.emplace_back((kRadius + off) * std::cos(a), (kRadius + off) * std::sin(a), z);
    }
  }
}

/// The ground beside it, level.
inline void addGround(Points& points, double z) {
  for (double a = 0.0; a < kTwoPi; a += 0.006) {
    for (double off = 0.3; off < 0.9; off += 0.1) {
      points.emplace_back((kRadius + off) * std::cos(a), (kRadius + off) * std::sin(a), z);
    }
  }
}

}  // namespace tank_datum::made_faces
