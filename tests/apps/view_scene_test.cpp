#include <gtest/gtest.h>

#include <cmath>

#include "support/made_datums.h"
#include "support/refused.h"
#include "tank_datum/core/unknown.h"
#include "view/scene.h"

namespace tank_datum::view::view_scene_test {

/// The octagon about (1, 2), R 10 m, whose elevations are 0.5 m + 1 mm a station; station 6 is missing.
ViewedResult octagon() {
  const Datum datum = made_datums::octagon();
  ViewedResult result;
  result.usable = true;
  result.origin = datum.origin;
  result.circle = datum.circle;
  result.stations = datum.stations;
  result.edge_points = datum.edge_points;
  return result;
}

/// The same with all stations, on a plane rising 1 mm/m towards +x, 0.5 m high at the centre.
ViewedResult tilted() {
  ViewedResult result = octagon();
  for (Station& s : result.stations) {
    s.flag = StationFlag::Measured;
    s.x = 1.0 + 10.0 * std::cos(s.direction), s.y = 2.0 + 10.0 * std::sin(s.direction);
    s.z = 0.5 + 0.001 * (s.x - 1.0);
  }
  return result;
}

TEST(SceneOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(SceneOptions())), "");
  SceneOptions o;
  o.range = -1.0;
  EXPECT_EQ(said(firstError(o)), "range, -1, expected >= 0");
  o = {}, o.exaggeration = 0.5;
  EXPECT_EQ(said(firstError(o)), "exaggeration, 0.5, expected >= 1");
  o = {}, o.exaggeration = NAN;
  EXPECT_NE(said(firstError(o)), "");
  o = {}, o.points = 999;
  EXPECT_EQ(said(firstError(o)), "points, 999, expected >= 1000");
  o = {}, o.label_every = -1;
  EXPECT_EQ(said(firstError(o)), "labels, -1, expected >= 0");
}

TEST(Colouring, ByHeightIsAboveTheMean) {
  const Colouring c = colouringOf({{0, 0, 0.5}, {0, 0, 0.7}, {0, 0, 0.4}}, tilted(), Colour::Height, 0.0);
  EXPECT_NEAR(c.values[0], 0.0, 1e-6);
  EXPECT_NEAR(c.values[1], 0.2, 1e-6);
  EXPECT_NEAR(c.low, -0.1, 1e-6);
  const Colouring set = colouringOf({{0, 0, 0.5}}, tilted(), Colour::Height, 0.3);
  EXPECT_EQ(set.low, -0.3);
  EXPECT_EQ(set.high, 0.3);
}

TEST(Colouring, ByHeightEndsWhere98PercentDo) {
  Points cloud;
  for (int i = 0; i <= 1000; ++i) cloud.emplace_back(0, 0, 0.5 + i);
  const Colouring c = colouringOf(cloud, tilted(), Colour::Height, 0.0);
  EXPECT_NEAR(c.low, 10.0, 1e-3);
  EXPECT_NEAR(c.high, 990.0, 1e-3);
}

TEST(Colouring, RadialIsPositiveOutside) {
  const Colouring c = colouringOf({{11.02, 2, 0}, {1, 11.97, 9}}, tilted(), Colour::Radial, 0.0);
  EXPECT_NEAR(c.values[0], 0.02, 1e-6);
  EXPECT_NEAR(c.values[1], -0.03, 1e-6);
  EXPECT_EQ(c.low, -0.05);
  EXPECT_EQ(c.high, 0.05);
  EXPECT_EQ(colouringOf({}, tilted(), Colour::Radial, 0.2).low, -0.2);
}

TEST(Colouring, DistanceIsToTheLineBetweenStations) {
  const Points cloud = {{11.03, 2, 0.51 + 0.04}, {1, 12, 0.7}, {1 - 10, 2, 0.49}};
  const Colouring c = colouringOf(cloud, tilted(), Colour::Distance, 0.0);
  EXPECT_NEAR(c.values[0], 0.05, 1e-6);
  EXPECT_NEAR(c.values[1], 0.2, 1e-6);
  EXPECT_NEAR(c.values[2], 0.0, 1e-6);
  EXPECT_EQ(c.low, 0.0);
  EXPECT_EQ(c.high, 1.0);
  // half way between stations 7 and 0: across the zero of directions
  const double a = -22.5 * kDegree, z = 0.5 * (octagon().stations[7].z + octagon().stations[0].z);
  const Colouring wrap =
      colouringOf({{1 + 10 * std::cos(a), 2 + 10 * std::sin(a), z + 0.02}}, octagon(), Colour::Distance, 0.0);
  EXPECT_NEAR(wrap.values[0], 0.02, 1e-6);
}

TEST(Colouring, DistanceIsUnknownInAGap) {
  EXPECT_TRUE(std::isnan(colouringOf({{1, -8, 0.5}}, octagon(), Colour::Distance, 0.0).values[0]));  // station 6
}

TEST(CurvePieces, AreClosedWithoutGaps) {
  const auto pieces = curvePieces(tilted(), 10.0);
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_EQ(pieces[0].size(), 9U);
  EXPECT_EQ(pieces[0].front(), pieces[0].back());
  EXPECT_NEAR(pieces[0][0].z(), 0.5 + 10.0 * 0.01, 1e-9);
  EXPECT_NEAR(curvePieces(tilted(), 1.0)[0][4].z(), 0.5 - 0.01, 1e-9);
}

TEST(CurvePieces, BreakAtMissingStations) {
  ViewedResult result = octagon();
  auto pieces = curvePieces(result, 1.0);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].size(), 7U);
  EXPECT_NEAR(pieces[0].front().z(), result.stations[7].z, 1e-12);  // from behind the gap, through 0
  EXPECT_NEAR(pieces[0].back().z(), result.stations[5].z, 1e-12);
  result.stations[2].z = kUnknown;
  pieces = curvePieces(result, 1.0);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size() + pieces[1].size(), 6U);
  for (Station& s : result.stations) s.z = kUnknown;
  EXPECT_TRUE(curvePieces(result, 1.0).empty());
}

TEST(TiltPlane, GoesThroughATiltedRing) {
  const Points plane = tiltPlane(tilted(), 10.0);
  ASSERT_GE(plane.size(), 36U);
  for (const auto& p : plane) {
    EXPECT_NEAR((p.head<2>() - Eigen::Vector2d(1, 2)).norm(), 10.5, 1e-9);
    EXPECT_NEAR(p.z(), 0.5 + 10.0 * 0.001 * (p.x() - 1.0), 1e-9);
  }
  ViewedResult few = tilted();
  few.stations.resize(3);
  EXPECT_TRUE(tiltPlane(few, 10.0).empty());
}

TEST(NamedStations, AreTheWorstAndThePlacesOfTheResult) {
  ViewedResult result = tilted();
  for (Station& s : result.stations) s.u = 0.001;
  result.stations[3].u = -0.004;
  result.marks = {{"stairs", 0.0}, {"manhole", 2.0 * kPi - 1e-9}};
  EXPECT_EQ(worstStation(result), 3);
  const auto named = namedStations(result);
  ASSERT_EQ(named.size(), 3U);
  EXPECT_EQ(named[0], (std::pair<std::size_t, std::string>(3, "worst out of plane: 3")));
  EXPECT_EQ(named[1], (std::pair<std::size_t, std::string>(0, "stairs")));
  EXPECT_EQ(named[2].first, 0U);  // a whole turn ends where it began
  for (Station& s : result.stations) s.u = kUnknown;
  EXPECT_EQ(worstStation(result), -1);
}

TEST(Colouring, IsInTheUnitsThatPeopleRead) {
  ViewedResult result = octagon();
  const Points cloud = {{result.circle.center.x() + 11.0, result.circle.center.y(), 0.0}};
  const Colouring metres = colouringOf(cloud, result, Colour::Radial, 2.0);
  result.display_units = "ft";
  const Colouring feet = colouringOf(cloud, result, Colour::Radial, 2.0);
  EXPECT_EQ(metres.title, "distance from the shell's circle [m]");
  EXPECT_EQ(feet.title, "distance from the shell's circle [ft]");
  EXPECT_NEAR(feet.values[0], metres.values[0] / 0.3048F, 1e-4);
  EXPECT_NEAR(feet.high, 2.0 / 0.3048, 1e-9);
  EXPECT_NEAR(feet.low, -2.0 / 0.3048, 1e-9);
}

TEST(NumberedStations, LeaveRoomForNames) {
  ViewedResult result;
  result.stations.resize(360);
  for (Station& s : result.stations) s.u = kUnknown;
  EXPECT_EQ(numberedStations(result, 90), (std::vector<std::size_t>{0, 90, 180, 270}));
  EXPECT_TRUE(numberedStations(result, 0).empty());
  result.marks = {{"stairs", 351.0 * kDegree}, {"manhole", 190.0 * kDegree}};  // 9 and 10 degrees from a number
  EXPECT_EQ(numberedStations(result, 90), (std::vector<std::size_t>{90, 180, 270}));
}

TEST(Bounds, HoldTheTankAsHighAsItsShellIsSeen) {
  const ViewedResult result = tilted();
  const Eigen::Vector2d& c = result.circle.center;
  const double r = result.circle.radius;
  const Points cloud(1000, Eigen::Vector3d(c.x() + r, c.y(), 12.0));
  const auto bounds = boundsOf(result, cloud);
  EXPECT_LT(bounds[0], c.x() - r);
  EXPECT_GT(bounds[1], c.x() + r);
  EXPECT_NEAR(bounds[5], 12.0, 1e-6);
  EXPECT_LT(bounds[4], 0.5);
  EXPECT_LT(boundsOf(result, {Eigen::Vector3d(c.x() + 2.0 * r, c.y(), 40.0)})[5], 5.0);  // a mast beside the tank
}

TEST(Bar, IsARoundLengthWithinTheRadius) {
  EXPECT_DOUBLE_EQ(barLength(10.0), 10.0);
  EXPECT_DOUBLE_EQ(barLength(9.9), 5.0);
  EXPECT_DOUBLE_EQ(barLength(30.0), 20.0);
  EXPECT_DOUBLE_EQ(barLength(0.3), 0.2);
}

TEST(Describe, IsInTheScansFrame) {
  const std::string text = describe(octagon(), 2);
  for (const char* part : {"station 2, azimuth 90 deg", "z 100.6270 m +- 0.50 mm (2 sigma)",
                           "x 500001.500 m, y 4000012.250 m", "radius 10.0000 m", "out of plane", "measured"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  EXPECT_NE(describe(octagon(), 5).find("interpolated"), std::string::npos);
  ViewedResult in_inches = octagon();
  in_inches.display_units = "in";
  for (const char* part : {"z 330.1411 ft +- 0.0197 in (2 sigma)", "radius 32.8084 ft", " in\n"}) {
    EXPECT_NE(describe(in_inches, 2).find(part), std::string::npos) << part << "\n" << describe(in_inches, 2);
  }
  EXPECT_EQ(describe(octagon(), 6), "station 6, azimuth 270 deg\nmissing");
}

TEST(NearestMark, IsWithinReachAndKnown) {
  const double unknown = kUnknown;
  const std::vector<Eigen::Vector2d> marks = {{0, 0}, {10, 0}, {unknown, unknown}, {13, 0}};
  EXPECT_EQ(nearestMark(marks, {9, 1}, 12.0), 1);
  EXPECT_EQ(nearestMark(marks, {12, 0}, 12.0), 3);
  EXPECT_EQ(nearestMark(marks, {40, 0}, 12.0), -1);
  EXPECT_EQ(nearestMark({}, {0, 0}, 12.0), -1);
}

}  // namespace tank_datum::view::view_scene_test
