#include <gtest/gtest.h>

#include "support/refused.h"
#include "support/synth_scenes.h"

namespace tank_datum::synth::synth_foot_test {

/// Sloping lip, kerbs that keep to the circle under a shell that does not, a sector higher than the rest.
SceneOptions oddFoot(const std::string& kind) {
  SceneOptions scene = richScene();
  Foundation& f = scene.tanks[0].foundation;
  f.kind = kind;
  f.weld = 0.0;
  f.plate_slope = -0.03;
  f.plate_slope_waves = {{3, 0.02, radians(40)}, {1, 0.01, radians(10)}};
  f.concentric = true;
  f.crown_inner = 0.12, f.crown_outer = 0.2;
  f.sectors = {{radians(90), radians(120), 0.025, 0.4}};
  scene.ground.drop = 0.4;
  scene.scanner.row_step = radians(0.05);
  scene.scanner.min_elevation = radians(-25), scene.scanner.max_elevation = radians(0);
  return scene;
}

/// What the foot is at one azimuth, written down once more.
struct OddFormula : Formula {
  explicit OddFormula(const SceneOptions& scene) : Formula(scene, 0) {}
  double slope(double a) const {
    double s = o.foundation.plate_slope;
    for (const Harmonic& h : o.foundation.plate_slope_waves) s += h.amplitude * std::cos(h.n * a - h.phase);
    return s;
  }
  double rise(double a) const {
    const Sector& s = o.foundation.sectors[0];
    const double from_end = (s.width / 2.0 - std::abs(std::remainder(a - s.azimuth, 2.0 * kPi))) * o.radius / s.edge;
    const double t = std::clamp(from_end, 0.0, 1.0);
    return s.rise * (10.0 * std::pow(t, 3) - 15.0 * std::pow(t, 4) + 6.0 * std::pow(t, 5));
  }
  /// Distance from the shell of something that stands `d` from the circle.
  double fromCircle(double a, double d) const { return d + o.radius - radius(a, 0.0); }
};

bool near(double a, double b) { return std::abs(a - b) < 2e-6; }  // 4-byte coordinates

TEST(SynthFoot, RingwallSlopesRisesAndKeepsToTheCircle) {
  const SceneOptions scene = oddFoot("annular_plate");
  const OddFormula tank(scene);
  const Foundation& f = tank.o.foundation;
  const Rows rows = rowsOf(scene);
  int plate = 0, wall = 0, risen = 0, face = 0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const auto [a, d, h, rho] = tank.place(pointOf(rows, i));
    const double lip = tank.plateWidth(a), edge = tank.fromCircle(a, f.ringwall_width);
    if (d < 2e-4 || d > edge + 1e-6 || h > 0.05) continue;  // the shell, which its growth has moved out by then
    const double top = tank.rise(a) - f.plate_thickness;
    if (near(h, tank.slope(a) * d) && d < lip + 1e-5) {
      ++plate;
    } else if (near(h, top) && d > lip - 1e-5) {
      ++wall;
      risen += tank.rise(a) > 0.024;
    } else {
      const bool lip_face = near(d, lip) && h < std::max(top, tank.slope(a) * lip) + 1e-5;
      EXPECT_TRUE(lip_face || (near(d, edge) && h < top + 1e-5)) << a << " " << d << " " << h << " of " << edge;
      ++face;
    }
  }
  EXPECT_GT(plate, 800);
  EXPECT_GT(wall, 3000);
  EXPECT_GT(risen, 500);
  EXPECT_GT(face, 500);
}

TEST(SynthFoot, CrownKeepsToTheCircle) {
  const SceneOptions scene = oddFoot("crown");
  const OddFormula tank(scene);
  const Foundation& f = tank.o.foundation;
  const Rows rows = rowsOf(scene);
  int crown = 0, slab = 0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const auto [a, d, h, rho] = tank.place(pointOf(rows, i));
    const double inner = tank.fromCircle(a, f.crown_inner), outer = tank.fromCircle(a, f.crown_outer);
    if (d > inner + 1e-5 && d < outer - 1e-5 && h < 0.1) {
      EXPECT_NEAR(h, f.crown_height + tank.rise(a), 2e-6);
      ++crown;
    } else if (d > outer + 1e-5 && d < tank.fromCircle(a, f.slab_width) - 1e-5 && h < 0.0) {
      EXPECT_NEAR(h, tank.rise(a) - f.slab_drop, 2e-6);
      ++slab;
    }
  }
  EXPECT_GT(crown, 1000);
  EXPECT_GT(slab, 1000);
}

TEST(SynthFoot, APadHasNeitherKerbNorSectors) {
  SceneOptions scene = plainScene();
  scene.tanks[0].foundation.concentric = true;
  EXPECT_EQ(said(firstError(scene)),
            "tanks[0].foundation.concentric, true, expected false for a pad, which has no kerb");
  scene.tanks[0].foundation.concentric = false;
  scene.tanks[0].foundation.sectors = {Sector{}};
  EXPECT_EQ(said(firstError(scene)),
            "tanks[0].foundation.sectors, given, expected none for a pad, which the shell stands on");
  scene.tanks[0].foundation.kind = "crown";
  EXPECT_EQ(said(firstError(scene)), "");
}

TEST(SynthFoot, SoilLiesOnEverySurface) {
  SceneOptions scene = oddFoot("annular_plate");
  scene.tanks[0].soil = {{radians(90), radians(100), 0.15, 0.3, 0.3, 0.0, 0.03}};
  const Scene built(scene);
  const Eigen::Vector3d datum = built.tank(0).datumPoint(radians(90), false);
  EXPECT_TRUE(built.tank(0).foundation.buried(radians(90)));
  const Hit hit =
      built.cast({datum + Eigen::Vector3d(0.0, 1.0, 1.0), Eigen::Vector3d(0.0, -1.0, -1.0).normalized()}, -1);
  EXPECT_EQ(hit.surface, Surface::Soil);
}

}  // namespace tank_datum::synth::synth_foot_test
