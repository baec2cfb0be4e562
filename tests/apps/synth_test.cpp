#include <gtest/gtest.h>

#include "support/synth_scenes.h"
#include "synth/root.h"
#include "synth/value_noise.h"

namespace tank_datum::synth::synth_test {

Ray rayTo(const Eigen::Vector3d& from, const Eigen::Vector3d& to) { return {from, (to - from).normalized()}; }

TEST(SynthRoot, FindsTheFirstOfTwo) {
  const auto parabola = [](double t) { return Sample{(t - 2.0) * (t - 3.0), 2.0 * t - 5.0}; };
  EXPECT_NEAR(firstRoot(parabola, 0.0, 0.0, 10.0), 2.0, 1e-12);
  EXPECT_EQ(firstRoot(parabola, 0.0, 0.0, 1.0), kNever);
}

TEST(SynthRoot, BendKeepsItFromPassingAThinDip) {
  const auto dip = [](double t) {
    const double u = (t - 5.0) / 0.1, bell = std::exp(-u * u);
    return Sample{0.9 - bell, 2.0 * u * bell / 0.1};
  };
  EXPECT_NEAR(firstRoot(dip, 2.0 / 0.01, 0.0, 10.0), 5.0 - 0.1 * std::sqrt(-std::log(0.9)), 1e-9);
}

TEST(SynthNoise, HasTheRmsAskedForAndItsDerivatives) {
  const ValueNoise noise(7, 0.002, 0.05);
  double sum = 0.0, squares = 0.0, largest = 0.0;
  const int n = 400;
  for (int i = 0; i < n * n; ++i) {
    const double x = 0.0173 * (i % n) - 3.0, y = 0.0131 * (i / n), step = 1e-6;
    const auto h = noise.at(x, y);
    sum += h.value, squares += h.value * h.value;
    largest =
        std::max(largest, std::abs(h.dx - (noise.at(x + step, y).value - noise.at(x - step, y).value) / (2 * step)));
  }
  EXPECT_NEAR(std::sqrt(squares / (n * n)), 0.002, 0.00008);
  EXPECT_NEAR(sum / (n * n), 0.0, 0.00005);
  EXPECT_LT(largest, 1e-5);
}

TEST(SynthScene, RayMeetsTheCylinderWhereItMust) {
  const Scene scene(plainScene());
  const Hit hit = scene.cast({{25.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}}, -1);
  EXPECT_EQ(hit.surface, Surface::Shell);
  EXPECT_NEAR(hit.t, 15.0, 1e-11);
  EXPECT_NEAR(std::abs(hit.normal.x()), 1.0, 1e-12);
  EXPECT_FALSE(scene.cast({{25.0, 0.0, 9.0}, {-1.0, 0.0, 0.0}}, -1).found());
  EXPECT_FALSE(scene.cast({{25.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}}, -1, 14.9).found());
}

TEST(SynthScene, EveryPointLiesOnASurface) {
  const SceneOptions options = richScene();
  const Formula tank(options, 0);
  const Scene scene(options);
  const Rows rows = rowsOf(options);
  int shell = 0, plate = 0, lip = 0, ringwall = 0, face = 0, weld = 0, ground = 0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const Eigen::Vector3d p = pointOf(rows, i);
    const auto [a, d, h, rho] = tank.place(p);
    const double width = tank.plateWidth(a), near = 1e-9;
    const bool in_taper = h > 1.2 && std::abs(h - 2.4 * std::round(h / 2.4)) < 0.005;
    const double courses = h > 1.2 ? -0.002 * std::floor(h / 2.4) : 0.0;
    if (std::abs(rho - tank.radius(a, h) - courses) < near && h > 0.0)
      ++shell;
    else if (in_taper && std::abs(rho - tank.radius(a, h) - courses) < 0.003)
      ++shell;
    else if (std::abs(h) < near && d > 0.0 && d < width + near)
      ++plate;
    else if (std::abs(d - width) < near && h > -0.010 - near && h < near)
      ++lip;
    else if (std::abs(h + 0.010) < near && d > width - near && d < 0.30 + near)
      ++ringwall;
    else if (std::abs(d - 0.30) < near && h < -0.010 + near)
      ++face;
    else if (std::abs(d + h - 0.007) < near && d > -near && h > -near)
      ++weld;
    else if (std::abs(p.z() - scene.ground().elevation(p.x(), p.y())) < near && d > 0.30 - near)
      ++ground;
    else
      FAIL() << "point " << i << ": d " << d << ", h " << h << ", off the shell by "
             << rho - tank.radius(a, h) - courses;
  }
  EXPECT_GT(shell, 100000);
  EXPECT_GT(plate, 100);
  EXPECT_GT(lip, 20);
  EXPECT_GT(ringwall, 500);
  EXPECT_GT(face, 500);
  EXPECT_GT(weld, 20);
  EXPECT_GT(ground, 10000);
}

TEST(SynthScene, CrownStandsHigherThanThePlate) {
  SceneOptions options = plainScene();
  options.tanks[0].foundation.kind = "crown";
  const Scene scene(options);
  const auto height = [&](double d) {
    return 0.5 - scene.cast({{10.0 + d, 1e-9, 0.5}, Eigen::Vector3d(-1e-9, 0.0, -1.0).normalized()}, -1).t;
  };
  EXPECT_NEAR(height(0.03), 0.0, 1e-9);
  EXPECT_NEAR(height(0.08), -0.010, 1e-9);
  EXPECT_NEAR(height(0.14), 0.015, 1e-9);
  EXPECT_NEAR(height(0.50), -0.035, 1e-9);
}

TEST(SynthScene, PadFallsOutwardsToItsShoulder) {
  SceneOptions options = plainScene();
  options.tanks[0].foundation.pad_fall = 0.02;
  const Scene scene(options);
  const Hit hit = scene.cast(rayTo({18.0, 0.0, 1.5}, {10.5, 0.0, -0.01}), -1);
  EXPECT_EQ(hit.surface, Surface::Pad);
  EXPECT_NEAR((Eigen::Vector3d(18.0, 0.0, 1.5) - Eigen::Vector3d(10.5, 0.0, -0.01)).norm(), hit.t, 1e-11);
  EXPECT_EQ(scene.cast(rayTo({18.0, 0.0, 1.5}, {11.1, 0.0, -0.02 - 0.0667}), -1).surface, Surface::Shoulder);
}

TEST(SynthScene, NothingIsSeenBehindABox) {
  SceneOptions options = plainScene();
  ObjectOptions box;
  box.gap = 3.0, box.length = 1.0, box.width = 2.0, box.height = 4.0;
  options.objects = {box};
  const Rows rows = rowsOf(options);
  int on_box = 0, hidden = 0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const Eigen::Vector3d p = pointOf(rows, i);
    if (std::abs(p.x() - 13.5) < 1e-9) ++on_box;
    // the scanner stands at x = 18, z = 1.55, so the box hides all of |y| < (18 - x) / 4.5 below its top
    const double spread = (18.0 - p.x()) / 4.5;
    if (p.x() < 12.4 && std::abs(p.y()) < spread - 1e-6 && p.z() < 1.55 + 2.1 * spread) ++hidden;
  }
  EXPECT_GT(on_box, 500);
  EXPECT_EQ(hidden, 0);
  const Truth truth = truthOf(Scene(options), 360);
  EXPECT_FALSE(truth.tanks[0].stations[0].visible);
  EXPECT_TRUE(truth.tanks[0].stations[40].visible);
  EXPECT_FALSE(truth.tanks[0].stations[180].visible);
}

TEST(SynthScene, EveryKindOfObjectIsMet) {
  for (const char* kind :
       {"box", "pipe_vertical", "pipe_parallel", "pipe_radial", "nozzle", "stairs", "tree", "bund_rectangle"}) {
    SceneOptions options = plainScene();
    ObjectOptions object;
    object.kind = kind;
    object.z = std::string(kind) == "box" ? 0.0 : 0.5;
    options.objects = {object};
    const Rows with = rowsOf(options), without = rowsOf(plainScene());
    EXPECT_NE(with, without) << kind;
  }
  SceneOptions options = plainScene();
  ObjectOptions wall;
  wall.kind = "bund", wall.place = "world", wall.radius = 25.0, wall.height = 2.0;
  options.objects = {wall};
  const Hit hit = Scene(options).cast({{18.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}, -1);
  EXPECT_EQ(hit.surface, Surface::Object);
  EXPECT_NEAR(hit.t, 7.0, 1e-11);
}

TEST(SynthScene, RingsAndRoofsStandWhereAsked) {
  SceneOptions options = plainScene();
  options.tanks[0].rings = {{3.0, 0.5, 0.02}};
  options.tanks[0].roof = "cone";
  const Scene scene(options);
  EXPECT_NEAR(scene.cast({{18.0, 0.0, 3.0}, {-1.0, 0.0, 0.0}}, -1).t, 7.5, 1e-11);
  EXPECT_EQ(scene.cast(rayTo({18.0, 0.0, 1.0}, {10.2, 0.0, 2.99}), -1).surface, Surface::Ring);
  const Hit roof = scene.cast(rayTo({18.0, 0.0, 20.0}, {5.0, 0.0, 8.0}), -1);
  EXPECT_EQ(roof.surface, Surface::Roof);
}

TEST(SynthScene, InsideTheFloorMeetsTheInnerFaceAtTheDatum) {
  SceneOptions options = richScene();
  options.tanks[0].course_flush = "outer";
  options.tanks[0].floor_cone = 0.01;
  options.tanks[0].foundation.weld = 0.0;
  options.scanner.inside = true;
  options.scanner.distance = 3.0;
  const Scene scene(options);
  const Formula tank(options, 0);
  const Truth truth = truthOf(scene, 90);
  EXPECT_TRUE(truth.tanks[0].inside);
  for (const TruthStation& s : truth.tanks[0].stations) {
    const auto [a, d, h, rho] = tank.place({s.x, s.y, s.z});
    EXPECT_NEAR(h, 0.0, 1e-9);
    EXPECT_NEAR(rho, tank.radius(a, 0.0) - 0.020, 1e-9);
    EXPECT_TRUE(s.visible);
    EXPECT_NEAR(scene.tank(0).floor.elevation(rho * std::cos(a), rho * std::sin(a)), s.z, 1e-9);
  }
  const Rows rows = rowsOf(options);
  int floor = 0, wall = 0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const auto [a, d, h, rho] = tank.place(pointOf(rows, i));
    if (std::abs(rho + 0.020 - tank.radius(a, h)) < 1e-9 && h < 2.3)
      ++wall;
    else if (h < 0.3)
      ++floor;
  }
  EXPECT_GT(wall, 50000);
  EXPECT_GT(floor, 50000);
}

TEST(SynthTruth, EqualsTheFormula) {
  SceneOptions options = richScene();
  options.offset = {512034.25, 4012877.5, 35.0};
  const Formula tank(options, 0);
  const Truth truth = truthOf(Scene(options), 720);
  ASSERT_EQ(truth.tanks[0].stations.size(), 720u);
  for (const TruthStation& s : truth.tanks[0].stations) {
    const Eigen::Vector3d world(s.x - 512034.25, s.y - 4012877.5, s.z - 35.0);
    const auto [a, d, h, rho] = tank.place(world);
    EXPECT_NEAR(h, 0.0, 1e-8);
    EXPECT_NEAR(d, 0.0, 1e-8);
    EXPECT_NEAR(std::remainder(std::atan2(world.y() + 7.0, world.x() - 3.0) - s.azimuth, 2.0 * kPi), 0.0, 1e-8);
    EXPECT_NEAR(s.radius, std::hypot(world.x() - 3.0, world.y() + 7.0), 1e-8);
  }
}

TEST(SynthTruth, KnowsWhatSoilCovers) {
  SceneOptions options = plainScene();
  options.tanks[0].soil = {Soil{}};
  const Scene scene(options);
  const Truth truth = truthOf(scene, 360);
  const auto& stations = truth.tanks[0].stations;
  EXPECT_TRUE(stations[0].covered && stations[5].covered && stations[355].covered);
  EXPECT_FALSE(stations[11].covered || stations[349].covered);
  EXPECT_FALSE(stations[0].visible);
  EXPECT_TRUE(stations[20].visible);
  const Hit hit = scene.cast(rayTo({18.0, 0.0, 1.5}, {10.01, 0.0, 0.0}), -1);
  EXPECT_EQ(hit.surface, Surface::Soil);
}

}  // namespace tank_datum::synth::synth_test
