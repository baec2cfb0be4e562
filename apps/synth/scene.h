#pragma once

#include "ground.h"
#include "objects.h"
#include "options.h"

namespace tank_datum::synth {

/// Everything a ray may meet, built from options that have no firstError.
class Scene {
 public:
  /// @throws Error (Option) when firstError(options) says something
  explicit Scene(const SceneOptions& options);

  const SceneOptions& options() const { return options_; }
  const Tanks& tanks() const { return tanks_; }
  const Tank& tank(int index) const { return *tanks_[static_cast<std::size_t>(index)]; }
  const Ground& ground() const { return ground_; }

  /// Where the output's frame has a place, but for the offset: turned by the frame's tilt.
  Eigen::Vector3d inFrame(const Eigen::Vector3d& place) const;

  /// Index of the tank a place is in, or -1.
  int tankAround(const Eigen::Vector3d& place) const;

  /// The first thing the ray meets within `reach`.
  /// @param inside  tankAround(ray.origin)
  Hit cast(const Ray& ray, int inside, double reach = kNever) const;

  /// Whether surely every ray that passes the hit within `radius` meets the same surface. A false is no proof of the
  /// contrary: this is a quick test that spares sub-rays.
  bool plainAround(const Ray& ray, const Hit& hit, int inside, double radius) const;

 private:
  SceneOptions options_;
  Ground ground_;
  Tanks tanks_;
  SolidTree solids_;
  std::vector<RingWall> ring_walls_;
};

}  // namespace tank_datum::synth
