#include "wall_above.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/scanned_tanks.h"
#include "tank_datum/datum.h"

namespace tank_datum::wall_above_test {

using namespace scanned_tanks;

constexpr double kRadius = 10.0, kReach = 0.5;

/// A tank whose foot is at height 0.
Tank tankAtZero() {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  tank.resolution = 0.05;
  return tank;
}

/// A wall 3 m high all round.
/// @param off  of the circle [m]
Points wall(double off, int columns) {
  Points points;
  for (int i = 0; i < columns; ++i) {
    const double azimuth = (i + 0.5) * kTwoPi / columns;
    for (double z = 0.005; z < 3.0; z += 0.01)
      points.push_back({(kRadius + off) * std::cos(azimuth), (kRadius + off) * std::sin(azimuth), z});
  }
  return points;
}

Points seenOf(const Tank& tank, const Points& points) {
  WallAbove above(tank, kReach, points.size());
  above.gather(0, points);
  return above.points();
}

/// Points of heights a few centimetres apart, from one to the other.
bool holdAllHeights(const Points& points, double from, double to) {
  for (double z = from; z < to; z += 0.05) {
    const auto beside = [z](const Eigen::Vector3d& p) { return std::abs(p.z() - z) < 0.025; };
    if (std::none_of(points.begin(), points.end(), beside)) return false;
  }
  return true;
}

TEST(WallAbove, GoesOnFromTheRingToWhereTheHighestFaceEnds) {
  const Points points = seenOf(tankAtZero(), wall(0.0, 720));
  EXPECT_TRUE(holdAllHeights(points, kReach, 2.1));
  EXPECT_FALSE(holdAllHeights(points, 0.0, kReach));
  EXPECT_FALSE(holdAllHeights(points, 2.1, 3.0));
}

TEST(WallAbove, HoldsWhatIsAsNearToTheShellAsANarrowFace) {
  EXPECT_FALSE(seenOf(tankAtZero(), wall(0.1, 720)).empty());
  EXPECT_TRUE(seenOf(tankAtZero(), wall(0.3, 720)).empty());
}

TEST(WallAbove, OfADenseScanIsASampleOfFewPointsALayer) {
  const Points points = seenOf(tankAtZero(), wall(0.0, 7200));
  const double layer_of_sector = static_cast<double>(points.size()) / 120.0 / ((2.1 - kReach) / 0.02);
  EXPECT_GT(layer_of_sector, 8.0);  // a layer of a sector is told by its median
  EXPECT_LT(layer_of_sector, 16.0);
}

TEST(WallAbove, IsNoneOfATankWhoseRingwallIsKnownOrThatIsSeenFromInside) {
  Tank known = tankAtZero(), inside = tankAtZero();
  known.ringwall_width = 0.3, known.ringwall_height = 0.5;
  inside.side = Side::Inside;
  EXPECT_TRUE(seenOf(known, wall(0.0, 720)).empty());
  EXPECT_TRUE(seenOf(inside, wall(0.0, 720)).empty());
}

TEST(WallAbove, ShowsAPlinthHigherThanTheRingWhichMayBeCladding) {
  SceneOptions scene = yard();
  scene.tanks[0].foundation.kind = "annular_plate";
  scene.tanks[0].foundation.plate_width = 0.05, scene.tanks[0].foundation.ringwall_width = 0.06;
  scene.ground.drop = 0.9;
  scene.scanner.field = "tank";
  scene.scanner.step = radians(0.25), scene.scanner.row_step = radians(0.08);
  const Scan scan = Scan::fromPoints(pointsOf(scene));
  const auto datumWith = [&](bool accept, std::optional<Circle> tank) {
    DatumOptions options;
    options.accept = accept, options.tank = tank;
    return extractDatum(scan, options);
  };
  const Datum asked = datumWith(false, {}), accepted = datumWith(true, {});
  EXPECT_EQ(asked.status, Status::Doubtful) << asked.message;
  EXPECT_NE(asked.message.find("its wall steps back by 0.06 m, 0.9 m above the ground"), std::string::npos);
  for (const Datum& datum : {asked, accepted, datumWith(false, Circle{{0.0, 0.0}, kRadius})}) {
    EXPECT_NEAR(datum.circle.radius, kRadius, 0.002);
    EXPECT_NEAR(datum.level.mean + datum.origin.z(), 0.0, 0.003);
    EXPECT_EQ(datum.usable(), datum.status != Status::Doubtful) << datum.message;
  }
  const Datum lower = datumWith(false, Circle{{0.0, 0.0}, kRadius + 0.06});
  EXPECT_TRUE(lower.usable()) << lower.message;
  EXPECT_NEAR(lower.circle.radius, kRadius + 0.06, 0.002);
  EXPECT_NEAR(lower.level.mean + lower.origin.z(), -0.9, 0.02);
}

}  // namespace tank_datum::wall_above_test
