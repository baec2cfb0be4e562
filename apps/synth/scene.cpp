#include "scene.h"

#include <algorithm>

#include "core/portable_math.h"
#include "core/refusal.h"
#include "rotation.h"

namespace tank_datum::synth {
namespace {

const SceneOptions& checked(const SceneOptions& options) {
  refuseFirst(firstError(options));
  return options;
}

Tanks makeTanks(const SceneOptions& scene) {
  Tanks tanks;
  const TankOptions& first = scene.tanks.front();
  for (const TankOptions& options : scene.tanks) {
    const auto index = static_cast<int>(tanks.size());
    const double depth = depthOfGround(scene.ground, first, foundationWidth(first.foundation), options);
    const std::uint64_t seed = mixed({scene.seed, 501, static_cast<std::uint64_t>(index)});
    tanks.push_back(std::make_unique<const Tank>(options, depth, index, seed));
  }
  return tanks;
}

}  // namespace

Scene::Scene(const SceneOptions& options)
    : options_(checked(options)),
      ground_(options.ground, options.tanks.front(), foundationWidth(options.tanks.front().foundation), options.seed),
      tanks_(makeTanks(options)) {
  Things things = makeThings(options_, ground_, tanks_);
  solids_ = SolidTree(std::move(things.solids));
  ring_walls_ = std::move(things.ring_walls);
}

Eigen::Vector3d Scene::inFrame(const Eigen::Vector3d& place) const {
  const double tilt = options_.frame_tilt, raised = options_.frame_tilt_direction;
  if (tilt == 0.0) return place;
  const TankOptions& first = options_.tanks.front();
  const Eigen::Vector3d pivot(first.x, first.y, first.base_elevation),
      axis(portable::sin(raised), -portable::cos(raised), 0.0);
  return pivot + rotation(tilt, axis) * (place - pivot);
}

int Scene::tankAround(const Eigen::Vector3d& place) const {
  for (std::size_t i = 0; i < tanks_.size(); ++i)
    if (tanks_[i]->contains(place)) return static_cast<int>(i);
  return -1;
}

Hit Scene::cast(const Ray& ray, int inside, double reach) const {
  Hit hit;
  hit.t = reach;
  solids_.trace(ray, hit);
  if (inside >= 0) {
    tank(inside).trace(ray, true, hit);
    return hit;
  }
  for (const RingWall& wall : ring_walls_) wall.trace(ray, hit);
  const double ground = ground_.firstPossible(ray);
  const bool ground_first = ground < hit.t && std::all_of(tanks_.begin(), tanks_.end(), [&](const auto& t) {
                              return ground < t->firstPossible(ray);
                            });
  if (ground_first) ground_.trace(ray, tanks_, hit);
  for (const auto& one : tanks_) one->trace(ray, false, hit);
  if (!ground_first) ground_.trace(ray, tanks_, hit);
  return hit;
}

bool Scene::plainAround(const Ray& ray, const Hit& hit, int inside, double radius) const {
  const double cosine = std::abs(hit.normal.dot(ray.direction)), margin = 2.0 * radius / std::max(cosine, 1e-3);
  if (inside >= 0 || !ring_walls_.empty() || cosine < 0.02) return false;
  const bool shell = hit.surface == Surface::Shell;
  if (!shell && hit.surface != Surface::Ground) return false;
  if (!solids_.clear(ray, margin, hit.t + margin)) return false;
  for (std::size_t i = 0; i < tanks_.size(); ++i) {
    const bool own = shell && hit.owner == static_cast<int>(i);
    if (own ? !tanks_[i]->plainShell(ray, hit.t, margin) : tanks_[i]->firstPossible(ray, margin) < hit.t + margin)
      return false;
  }
  return true;
}

}  // namespace tank_datum::synth
