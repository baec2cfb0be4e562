// A tank described at a circle that is known, and what options rule out.

#include <gtest/gtest.h>

#include <cmath>

#include "locate/locate.h"
#include "support/refused.h"
#include "support/scanned_tanks.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum::known_circle_test {

using scanned_tanks::kTurn;
using scanned_tanks::pointsOf;
using scanned_tanks::yard;
using synth::SceneOptions;

TEST(LocateTanks, MinRadiusIsAnOption) {
  SceneOptions scene = yard();
  scene.tanks[0].radius = 3.0, scene.tanks[0].height = 4.0;
  const Scan scan = Scan::fromPoints(pointsOf(scene));
  LocateOptions options;
  EXPECT_EQ(locateTanks(scan, options).size(), 1U);
  options.min_radius = 3.5;
  EXPECT_TRUE(locateTanks(scan, options).empty());
}

TEST(DescribeTank, LooksAtAKnownCircle) {
  const Scan scan = Scan::fromPoints(pointsOf(yard()));
  const Circle known{-scan.origin().head<2>(), 10.0};
  const auto tank = describeTank(scan, known, {});
  ASSERT_TRUE(tank.has_value());
  EXPECT_NEAR(tank->circle.radius, 10.0, 0.02);
  EXPECT_EQ(tank->side, Side::Outside);
  EXPECT_TRUE(tank->has_foundation);
  EXPECT_GT(tank->coverage, 0.9 * kTurn);
  EXPECT_NEAR(tank->foot(1.0) + scan.origin().z(), 0.0, 0.25);
  EXPECT_FALSE(describeTank(scan, {known.center + Eigen::Vector2d(100, 0), 10.0}, {}).has_value());
  EXPECT_FALSE(describeTank(Scan::fromPoints({}), known, {}).has_value());
}

TEST(Tank, KnowsAzimuthsAboutItsCentre) {
  Tank tank;
  tank.circle = {{3.0, -4.0}, 10.0};
  EXPECT_DOUBLE_EQ(tank.azimuthOf({3.0, 6.0}), kTurn / 4);
  EXPECT_DOUBLE_EQ(tank.azimuthOf({3.0, -14.0}), 0.75 * kTurn);
}

TEST(LocateOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(LocateOptions())), "");
  LocateOptions options;
  options.min_radius = -1.0;
  EXPECT_EQ(said(firstError(options)), "min_radius, -1, expected > 0 m");
  for (const double arc : {0.0, 6.3, static_cast<double>(NAN)}) {
    options = {};
    options.min_arc = arc;
    EXPECT_EQ(said(firstError(options)).rfind("locate.min_arc_deg, ", 0), 0U) << arc;
  }
  options = {};
  options.sample_points = 9'999;
  EXPECT_EQ(said(firstError(options)), "locate.sample_points, 9999, expected >= 10000");
}

}  // namespace tank_datum::known_circle_test
