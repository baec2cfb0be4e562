#pragma once

#include <cstdint>
#include <string>

#include "floor.h"
#include "foundation.h"
#include "shell.h"
#include "tank_shape.h"

namespace tank_datum::synth {

/// One tank with all that is swept round it. Stays where it was made: its parts refer to its shape.
class Tank {
 public:
  /// @param depth  how far below the datum the ground may lie [m]
  Tank(const TankOptions& options, double depth, int index, std::uint64_t seed)
      : shape(options, seed), foundation(shape, depth, seed), floor(shape, seed), index_(index) {}
  Tank(const Tank&) = delete;
  Tank& operator=(const Tank&) = delete;

  const TankShape shape;
  const FoundationShape foundation;
  const FloorShape floor;

  bool contains(const Eigen::Vector3d& world) const;

  /// The nearest hit with this tank, seen from inside or outside, if nearer than `hit`.
  void trace(const Ray& ray, bool inside, Hit& hit) const;

  /// The ray comes no nearer to anything of the tank than `margin` before this.
  double firstPossible(const Ray& ray, double margin = 0.0) const;

  /// Whether the shell goes on for `margin` all round a place on it, with nothing of the tank in front.
  bool plainShell(const Ray& ray, double t, double margin) const;

  /// A point of the datum line in the world, at a true azimuth about the centre.
  Eigen::Vector3d datumPoint(double azimuth, bool inside) const { return shellPoint(azimuth, 0.0, inside); }

  /// A point of the shell in the world, at a true azimuth about the centre of the foot and a height above the datum.
  Eigen::Vector3d shellPoint(double azimuth, double height, bool inside) const;

  /// Distance from the shell foot and height above the datum of a point in the world.
  Eigen::Vector2d fromDatum(const Eigen::Vector3d& world, bool inside) const;

 private:
  int index_;
};

}  // namespace tank_datum::synth
