#pragma once

#include <cmath>

#include "support/synth_scenes.h"
#include "tank_datum/locate/tank.h"

/// Small ray-cast scans with their truth, for the tests of locate and refine.
namespace tank_datum::scanned_tanks {

using synth::degrees;
using synth::radians;
using synth::SceneOptions;

inline constexpr double kTurn = 6.283185307179586;

/// A 20 m tank on a pad, its datum tilted and out of plane; four scanners, 1.5 mm of noise.
inline SceneOptions tank20() {
  SceneOptions scene;
  synth::TankOptions& tank = scene.tanks[0];
  tank.radius = 10.0, tank.height = 6.0;
  tank.tilt_slope = 0.001, tank.tilt_direction = radians(40);
  tank.harmonics = {{2, 0.004, radians(30)}, {3, 0.002, radians(100)}};
  tank.foundation.pad_fall = 0.02;
  tank.foundation.roughness = 0.0005;
  scene.ground.drop = 0.2;
  scene.scanner.count = 4, scene.scanner.distance = 8.0;
  scene.scanner.field = "tank";
  scene.scanner.step = radians(0.15), scene.scanner.row_step = radians(0.08);
  scene.scanner.min_elevation = radians(-16), scene.scanner.max_elevation = radians(-5.5);
  return scene;
}

/// A 20 m tank 6 m high on a pad, seen coarsely and whole by four scanners.
inline SceneOptions yard() {
  SceneOptions scene;
  scene.tanks[0].radius = 10.0, scene.tanks[0].height = 6.0;
  scene.ground.drop = 0.2;
  scene.scanner.count = 4;
  scene.scanner.step = radians(0.7), scene.scanner.row_step = radians(0.45);
  scene.scanner.min_elevation = radians(-30), scene.scanner.max_elevation = radians(30);
  scene.scanner.max_range = 40.0;
  return scene;
}

inline Points pointsOf(const SceneOptions& scene) {
  const synth::Rows rows = synth::rowsOf(scene);
  Points points;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) points.push_back(synth::pointOf(rows, i));
  return points;
}

inline synth::TruthTank truthOf(const SceneOptions& scene, int stations = 360, std::size_t tank = 0) {
  return synth::truthOf(synth::Scene(scene), stations).tanks[tank];
}

/// What locate would say of the scene's first tank, millimetres off; relative to `origin`.
inline Tank roughTank(const SceneOptions& scene, const Eigen::Vector3d& origin) {
  const synth::TankOptions& o = scene.tanks[0];
  Tank tank;
  tank.circle = {Eigen::Vector2d(o.x + 0.006, o.y - 0.004) - origin.head<2>(), o.radius + 0.005};
  tank.rms = 0.01;
  tank.coverage = kTurn;
  tank.side = scene.scanner.inside ? Side::Inside : Side::Outside;
  const double tilt = o.radius * o.tilt_slope;
  tank.foot.coefficients = Eigen::Vector3d(o.base_elevation + 0.01 - origin.z(), tilt * std::cos(o.tilt_direction),
                                           tilt * std::sin(o.tilt_direction));
  tank.resolution = 0.02;
  tank.has_foundation = true;
  return tank;
}

}  // namespace tank_datum::scanned_tanks
