#pragma once

#include <utility>
#include <vector>

#include "foot/foot_roughness.h"

namespace tank_datum::made_feet {

/// A level fit of points.
inline FittedPoints levelOf(std::vector<FootPoint> points, double noise, double steepness) {
  FittedPoints fitted{std::move(points), {}, steepness};
  FootFit& fit = fitted.fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0;
  fit.noise = noise, fit.sigma = noise, fit.points = fitted.points.size();
  return fitted;
}

}  // namespace tank_datum::made_feet
