#include "locate/locate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "locate/sample_ladder.h"
#include "support/made_clouds.h"
#include "support/scanned_tanks.h"

namespace tank_datum::locate_test {

using scanned_tanks::pointsOf;
using scanned_tanks::yard;
using synth::ObjectOptions;
using synth::radians;
using synth::SceneOptions;

constexpr double kTurn = scanned_tanks::kTurn;

struct Found {
  std::vector<Tank> tanks;
  Eigen::Vector3d origin;

  Eigen::Vector2d center(std::size_t i = 0) const { return tanks[i].circle.center + origin.head<2>(); }
  double foot(double azimuth, std::size_t i = 0) const { return tanks[i].foot(azimuth) + origin.z(); }
};

Found locate(const Points& points, const LocateOptions& options = {}) {
  const Scan scan = Scan::fromPoints(points);
  return {locateTanks(scan, options), scan.origin()};
}
Found locate(const SceneOptions& scene, const LocateOptions& options = {}) { return locate(pointsOf(scene), options); }

void expectThe20mTank(const Found& found, double tolerance = 0.03) {
  ASSERT_EQ(found.tanks.size(), 1U);
  EXPECT_NEAR(found.tanks[0].circle.radius, 10.0, tolerance);
  EXPECT_NEAR(found.center().norm(), 0.0, tolerance);
  EXPECT_TRUE(found.tanks[0].has_foundation);
  for (const double a : {0.0, 1.0, 3.0, 5.0}) EXPECT_NEAR(found.foot(a), 0.0, 0.25) << a;
}

ObjectOptions thing(const std::string& kind, double azimuth_deg, double gap) {
  ObjectOptions object;
  object.kind = kind;
  object.azimuth = radians(azimuth_deg), object.gap = gap;
  return object;
}

/// Ground a step away from each scanner is so dense that the shell looks like stray points beside it.
TEST(LocateTanks, DenseGroundBesideTheScannersHidesNoTank) {
  Points points = pointsOf(yard());
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(18.0, 0.0), {0.0, 18.0}, {-18.0, 0.0}, {0.0, -18.0}}) {
    for (int i = 0; i < 90'000; ++i)
      points.emplace_back(at.x() + 0.005 * (i % 300), at.y() + 0.005 * (i / 300), -0.2 + 0.001 * (i % 7));
  }
  ASSERT_TRUE(samplesOf(lookAt(Scan::fromPoints(points), 1), {}, 1).front().strays);
  expectThe20mTank(locate(points));
}

TEST(LocateTanks, SayWhatShareOfTheScanIsNearTheFoot) {
  const Points points = pointsOf(yard());
  const Found found = locate(points);
  ASSERT_EQ(found.tanks.size(), 1U);
  const Tank& tank = found.tanks[0];
  const auto near = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d local = p - found.origin;
    return std::abs((local.head<2>() - tank.circle.center).norm() - tank.circle.radius) <= Tank::kNear &&
           std::abs(local.z() - tank.foot(tank.azimuthOf(local.head<2>()))) <= Tank::kNear;
  });
  EXPECT_NEAR(tank.near_foot, static_cast<double>(near) / static_cast<double>(points.size()), 0.002);
  EXPECT_GT(tank.near_foot, 0.01);
}

TEST(LocateTanks, FindTheOneFromOutside) {
  const Found found = locate(yard());
  expectThe20mTank(found);
  EXPECT_EQ(found.tanks[0].side, Side::Outside);
  EXPECT_GT(found.tanks[0].coverage, 0.9 * kTurn);
  EXPECT_NEAR(found.tanks[0].height, 6.0, 1.0);
}

TEST(LocateTanks, FindTheOneFromInside) {
  SceneOptions scene = yard();
  scene.scanner.inside = true;
  scene.scanner.count = 1, scene.scanner.distance = 2.0;
  const Found found = locate(scene);
  expectThe20mTank(found);
  EXPECT_EQ(found.tanks[0].side, Side::Inside);
}

TEST(LocateTanks, AHundredDegreesOfArcAreEnough) {
  Points seen;
  for (const auto& p : pointsOf(yard())) {
    const double a = std::atan2(p.y(), p.x());
    if (a > 0.0 && a < radians(100)) seen.push_back(p);
  }
  const Found found = locate(seen);
  expectThe20mTank(found, 0.1);
  EXPECT_NEAR(found.tanks[0].coverage, radians(100), radians(12));
  LocateOptions options;
  options.min_arc = radians(120);
  EXPECT_TRUE(locate(seen, options).tanks.empty());
}

TEST(LocateTanks, ThreeTanksInABundAreThreeByLongestSeenArc) {
  SceneOptions scene = yard();
  scene.tanks.resize(3, scene.tanks[0]);
  scene.tanks[1].x = 22.0, scene.tanks[1].radius = 6.0;
  scene.tanks[2].x = 2.0, scene.tanks[2].y = 19.0, scene.tanks[2].radius = 4.0;
  ObjectOptions bund = thing("bund", 0, 0);
  bund.place = "world", bund.x = 8.0, bund.y = 4.0;
  bund.radius = 30.0, bund.height = 1.2;
  scene.objects = {bund};
  scene.scanner.stations = {{13.0, 12.0}, {-9.0, 14.0}, {12.0, -11.0}, {31.0, 6.0}, {-12.0, -6.0}, {6.0, 27.0}};
  const Found found = locate(scene);
  ASSERT_EQ(found.tanks.size(), 3U);
  for (const auto& wanted : scene.tanks) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      hits += (found.center(i) - Eigen::Vector2d(wanted.x, wanted.y)).norm() < 0.1 &&
              std::abs(found.tanks[i].circle.radius - wanted.radius) < 0.1;
    }
    EXPECT_EQ(hits, 1U) << wanted.radius;
  }
  const auto arc = [&](std::size_t i) { return found.tanks[i].coverage * found.tanks[i].circle.radius; };
  EXPECT_GE(arc(0), arc(1));
  EXPECT_GE(arc(1), arc(2));
  EXPECT_NEAR(found.tanks[0].circle.radius, 10.0, 0.1);
}

/// A tank on a concrete ring 0.3 m wide and this high.
SceneOptions onRingwall(double height, double step_deg) {
  SceneOptions scene = yard();
  scene.tanks[0].foundation.kind = "annular_plate";
  scene.ground.drop = height;
  scene.scanner.field = "tank";
  scene.scanner.step = radians(step_deg), scene.scanner.row_step = radians(0.6 * step_deg);
  scene.scanner.max_elevation = radians(15);
  return scene;
}

TEST(LocateTanks, ARingwallIsNotTheShell) {
  expectThe20mTank(locate(onRingwall(0.4, 0.7)));
  const Found fine = locate(onRingwall(0.8, 0.25));
  ASSERT_EQ(fine.tanks.size(), 1U);
  EXPECT_NEAR(fine.tanks[0].circle.radius, 10.0, 0.03);
}

TEST(LocateTanks, AHighRingwallIsNotTheShell) {
  expectThe20mTank(locate(onRingwall(0.6, 0.35)));
  expectThe20mTank(locate(onRingwall(0.8, 0.35)));
}

TEST(LocateTanks, AHouseATreeAndPipesAreNone) {
  SceneOptions scene = yard();
  scene.tanks[0].x = 500.0;  // out of sight
  scene.scanner.stations = {{6.0, 0.0}, {-6.0, 0.0}, {0.0, 7.0}};
  for (const double x : {-14.0, 14.0}) {
    ObjectOptions house = thing("box", 0, 0);
    house.place = "world", house.x = x, house.length = 8.0, house.width = 6.0, house.height = 5.0;
    scene.objects.push_back(house);
  }
  for (const double x : {-4.0, 0.0, 4.0}) {
    ObjectOptions tree = thing("tree", 0, 0), pipe = thing("pipe_vertical", 0, 0);
    tree.place = pipe.place = "world";
    tree.x = x, tree.y = -8.0, tree.width = 4.0, tree.height = 4.0, tree.radius = 0.2;
    pipe.x = x, pipe.y = 12.0, pipe.radius = 0.4, pipe.height = 6.0;
    scene.objects.push_back(tree);
    scene.objects.push_back(pipe);
  }
  scene.ground.drop = 0.0;
  scene.scanner.step = radians(0.4), scene.scanner.row_step = radians(0.3);
  EXPECT_TRUE(locate(scene).tanks.empty());
}

TEST(LocateTanks, ARoomOrAFloorIsNone) {
  EXPECT_TRUE(locate(made_clouds::roomPoints()).tanks.empty());
  EXPECT_TRUE(locate(made_clouds::floorPoints(20'000, 10.0)).tanks.empty());
  EXPECT_TRUE(locate(Points()).tanks.empty());
}

TEST(LocateTanks, ClutterSlopingGroundARoofAndGirdersDoNotMislead) {
  for (const char* roof : {"cone", "dome"}) {
    SceneOptions scene = yard();
    scene.tanks[0].roof = roof;
    scene.tanks[0].rings = {{2.5, 0.4, 0.01}, {5.8, 0.4, 0.01}};
    scene.ground.slope = 0.05, scene.ground.roughness = 0.02;
    scene.clutter = {8, 8, 0.8, 6.0};
    scene.objects = {thing("stairs", 60, 0.15), thing("tree", 200, 5.0)};
    scene.measurement.outliers = 0.005;
    expectThe20mTank(locate(scene), 0.05);
  }
}

TEST(LocateTanks, TheFootFollowsATilt) {
  SceneOptions scene = yard();
  scene.tanks[0].tilt_slope = 0.03, scene.tanks[0].tilt_direction = radians(50);
  const Found found = locate(scene);
  ASSERT_EQ(found.tanks.size(), 1U);
  const double across = found.foot(radians(50)) - found.foot(radians(230));
  EXPECT_NEAR(across, 0.6, 0.15);
}

TEST(LocateTanks, SamplePointsBoundTheSample) {
  const Points points = pointsOf(yard());
  LocateOptions options;
  options.sample_points = 40'000;
  const Found coarse = locate(points, options), fine = locate(points);
  ASSERT_EQ(coarse.tanks.size(), 1U);
  expectThe20mTank(fine);
  EXPECT_GT(coarse.tanks[0].resolution, fine.tanks[0].resolution);
}

}  // namespace tank_datum::locate_test
