#pragma once

#include <vector>

#include "ground.h"
#include "solids.h"

namespace tank_datum::synth {

/// The objects of a scene as solids.
struct Things {
  std::vector<Solid> solids;
  std::vector<RingWall> ring_walls;
};

/// The objects listed and the seeded clutter after them, which counts on as objects.
std::vector<ObjectOptions> allObjects(const SceneOptions& scene);

Things makeThings(const SceneOptions& scene, const Ground& ground, const Tanks& tanks);

}  // namespace tank_datum::synth
