#pragma once

#include <cmath>
#include <vector>

#include "synth/scanner.h"
#include "synth/tank_curves.h"
#include "synth/truth.h"

/// Scenes of known answers for the tests of the simulator.
namespace tank_datum::synth {

/// A cylinder of 10 m radius on a flat pad, level ground, one scanner, no noise, nothing random.
inline SceneOptions plainScene() {
  SceneOptions scene;
  scene.tanks[0].radius = 10.0;
  scene.tanks[0].height = 8.0;
  scene.scanner.count = 1;
  scene.scanner.distance = 8.0;
  scene.scanner.step = radians(0.5);
  scene.scanner.max_range = 40.0;
  scene.measurement.range_sigma = 0.0;
  return scene;
}

/// Everything smooth at once: tilt with lean, harmonics, dip, lobes, courses, plate, weld, sloping ground.
inline SceneOptions richScene() {
  SceneOptions scene = plainScene();
  TankOptions& tank = scene.tanks[0];
  tank.x = 3.0, tank.y = -7.0, tank.base_elevation = 1.5;
  tank.tilt_slope = 0.004, tank.tilt_direction = radians(70);
  tank.harmonics = {{2, 0.006, radians(30)}, {5, 0.002, radians(100)}};
  tank.dips = {{radians(200), radians(30), 0.015}};
  tank.out_of_round = {{3, 0.010, radians(20), 1.0}};
  tank.lobes.amplitude = 0.03;
  tank.course_step = 0.002;
  tank.thickness = 0.020;
  tank.foundation.kind = "annular_plate";
  tank.foundation.weld = 0.007;
  tank.foundation.plate_width_variation = 0.004;
  scene.ground.slope = 0.03, scene.ground.slope_direction = radians(250), scene.ground.drop = 0.3;
  scene.scanner.count = 3;
  scene.scanner.step = radians(0.25);
  return scene;
}

/// The whole scan in memory, rows of x, y, z, intensity.
inline Rows rowsOf(const SceneOptions& options, unsigned threads = 2) {
  Rows all;
  scanScene(
      Scene(options), [&](std::size_t, const Rows& rows) { all.insert(all.end(), rows.begin(), rows.end()); }, threads);
  return all;
}

inline Eigen::Vector3d pointOf(const Rows& rows, std::size_t i) {
  return {rows[4 * i], rows[4 * i + 1], rows[4 * i + 2]};
}

/// The formulas of a tank, written down once more without tables and rays.
struct Formula {
  TankOptions o;
  std::vector<ShellHarmonic> shell, lip;

  Formula(const SceneOptions& scene, int index)
      : o(scene.tanks[static_cast<std::size_t>(index)]),
        shell(shellHarmonics(o, seedOf(scene, index))),
        lip(lipHarmonics(o, seedOf(scene, index))) {}

  static std::uint64_t seedOf(const SceneOptions& scene, int index) {
    return mixed({scene.seed, 501, static_cast<std::uint64_t>(index)});
  }

  double datum(double a) const {
    double z = o.base_elevation + o.tilt_slope * o.radius * std::cos(a - o.tilt_direction);
    for (const Harmonic& h : o.harmonics) z += h.amplitude * std::cos(h.n * a - h.phase);
    for (const Dip& dip : o.dips) {
      const double off = std::remainder(a - dip.azimuth, 2.0 * kPi);
      if (std::abs(off) < dip.width / 2.0) z -= dip.depth * std::pow(std::cos(kPi * off / dip.width), 4);
    }
    return z;
  }
  double radius(double a, double h) const {
    double r = o.radius;
    for (const ShellHarmonic& s : shell)
      r += s.amplitude * (1.0 + s.growth * h / o.height) * std::cos(s.n * a - s.phase);
    return r;
  }
  double plateWidth(double a) const { return o.foundation.plate_width + harmonicCurve(lip, a, false).value; }

  /// Azimuth, distance from the foot, height above the datum and, unsheared by the lean, rho.
  struct Place {
    double azimuth, d, h, rho;
  };
  Place place(const Eigen::Vector3d& p) const {
    const double up = p.z() - o.base_elevation;
    const double x = p.x() - o.x + o.tilt_slope * std::cos(o.tilt_direction) * up;
    const double y = p.y() - o.y + o.tilt_slope * std::sin(o.tilt_direction) * up;
    const double a = std::atan2(y, x), rho = std::hypot(x, y);
    return {a, rho - radius(a, 0.0), p.z() - datum(a), rho};
  }
};

}  // namespace tank_datum::synth
