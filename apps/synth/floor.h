#pragma once

#include "tank_shape.h"
#include "value_noise.h"

namespace tank_datum::synth {

/// The tank's bottom as a scanner inside sees it, with the fillet weld in the corner. It meets the inner face of the
/// shell at the datum; tilt goes on as a plane, other settlement fades inwards, the cone rises to the centre.
class FloorShape {
 public:
  FloorShape(const TankShape& tank, std::uint64_t seed);

  void trace(const TankRay& local, int owner, Hit& hit) const;

  /// Elevation without roughness at a place in the tank's frame [m].
  double elevation(double x, double y) const;

 private:
  Sample elevationAlong(const TankPoint& p, const Eigen::Vector3d& direction) const;
  double crossFloor(const TankRay& local, double begin, double end) const;
  double crossWeld(const TankRay& local, double begin, double end) const;

  const TankShape& tank_;
  ValueNoise noise_;
};

}  // namespace tank_datum::synth
