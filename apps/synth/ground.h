#pragma once

#include <memory>
#include <vector>

#include "tank.h"
#include "value_noise.h"

namespace tank_datum::synth {

using Tanks = std::vector<std::unique_ptr<const Tank>>;

/// The rough inclined plane the tanks stand on; it begins where their foundations end.
class Ground {
 public:
  Ground(const GroundOptions& options, const TankOptions& first_tank, double first_width, std::uint64_t seed);

  void trace(const Ray& ray, const Tanks& tanks, Hit& hit) const;

  /// The ray cannot meet the ground before this.
  double firstPossible(const Ray& ray) const;

  /// Elevation without roughness [m].
  double elevation(double x, double y) const { return level_ + slope_x_ * x + slope_y_ * y; }

 private:
  bool masked(const Tank& tank, const Eigen::Vector3d& world) const;
  double leaveMask(const Tank& tank, const Ray& ray, double t) const;

  GroundOptions options_;
  double level_, slope_x_, slope_y_;
  ValueNoise noise_;
};

/// How far the ground may lie below the datum of any tank [m], for the depth of its foundation's outermost face.
double depthOfGround(const GroundOptions& ground, const TankOptions& first_tank, double first_width,
                     const TankOptions& tank);

/// From the shell to the shoulder, ringwall edge or slab edge [m].
double foundationWidth(const Foundation& foundation);

}  // namespace tank_datum::synth
