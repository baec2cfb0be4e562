#include "stations/stations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "fit/spline.h"
#include "support/refused.h"

namespace tank_datum::stations_test {

constexpr double kTurn = 6.283185307179586;
const Eigen::Vector2d kCenter(3.0, -4.0);

std::size_t countOf(const std::vector<Station>& stations, StationFlag flag) {
  return static_cast<std::size_t>(
      std::count_if(stations.begin(), stations.end(), [&](const Station& s) { return s.flag == flag; }));
}

/// Flags of 360 stations with a gap from the first (counted round) over `length` stations.
std::vector<Station> withGap(std::size_t first, std::size_t length, const StationOptions& options = {}) {
  std::vector<Station> stations = emptyStations(options);
  std::vector<bool> supported(stations.size(), true);
  for (std::size_t i = 0; i < length; ++i) supported[(first + i) % stations.size()] = false;
  const std::vector<StationFlag> flags = flagsOf(supported, options);
  for (std::size_t i = 0; i < flags.size(); ++i) stations[i].flag = flags[i];
  return stations;
}

/// Edge points every degree of [from, to) and a curve through a tank of 10 m radius about kCenter.
struct Tank10 {
  EdgePoints edge;
  ClosedSpline curve;

  static double elevation(double a) { return 1.0 + 0.02 * std::sin(a) + 0.01 * std::cos(2 * a); }
  explicit Tank10(double from = 0.0, double to = 360.0, double step = 1.0) {
    edge.circle = {kCenter, 10.0};
    std::vector<Eigen::Vector3d> points;
    for (double degrees = from; degrees < to; degrees += step) {
      const double a = degrees * kDegree;
      edge.azimuths.push_back(a);
      points.emplace_back(kCenter.x() + 10 * std::cos(a), kCenter.y() + 10 * std::sin(a), elevation(a));
    }
    SplineOptions options;
    options.control_points = 90;
    curve = fitClosedSpline(points, edge.azimuths, options);
  }
  std::vector<Station> sample(const StationOptions& options = {}) const {
    std::vector<Station> stations = emptyStations(options);
    return withParts(stations, samplePaperCurve(stations, curve, edge, options));
  }
};

TEST(EmptyStations, KnowTheirAzimuthsAndNothingElse) {
  const auto stations = emptyStations({});
  ASSERT_EQ(stations.size(), 360U);
  EXPECT_EQ(stations[0].azimuth, 0.0);
  EXPECT_DOUBLE_EQ(stations[90].azimuth, kTurn / 4);
  EXPECT_DOUBLE_EQ(stations[90].direction, kTurn / 4);
  EXPECT_EQ(countOf(stations, StationFlag::Missing), 360U);
  for (const double value : {stations[7].z, stations[7].x, stations[7].sigma_z, stations[7].radius, stations[7].u}) {
    EXPECT_TRUE(std::isnan(value));
  }
  EXPECT_FALSE(stations[7].n_shell.has_value());
}

TEST(EmptyStations, CountIsAnOption) {
  StationOptions options;
  options.count = 8;
  EXPECT_EQ(emptyStations(options).size(), 8U);
  EXPECT_DOUBLE_EQ(emptyStations(options)[1].azimuth, kTurn / 8);
}

TEST(EmptyStations, StartAtTheZeroAzimuth) {
  StationOptions options;
  options.zero_azimuth = 300 * kDegree;
  const auto stations = emptyStations(options);
  EXPECT_EQ(stations[0].azimuth, 0.0);
  EXPECT_NEAR(stations[0].direction, 300 * kDegree, 1e-12);
  EXPECT_NEAR(stations[100].direction, 40 * kDegree, 1e-12);
}

TEST(EmptyStations, RunClockwiseWhenAsked) {
  StationOptions options;
  options.clockwise = true;
  options.zero_azimuth = 90 * kDegree;  // north, as a compass counts
  const auto stations = emptyStations(options);
  EXPECT_NEAR(stations[90].azimuth, 90 * kDegree, 1e-12);
  EXPECT_NEAR(std::remainder(stations[90].direction, kTurn), 0.0, 1e-12);  // east
  EXPECT_NEAR(stations[180].direction, 270 * kDegree, 1e-12);
}

TEST(FlagGaps, OfNineAndTenDegreesAreBridgedAndOfElevenAreNot) {
  EXPECT_EQ(countOf(withGap(20, 9), StationFlag::Interpolated), 9U);
  EXPECT_EQ(countOf(withGap(20, 10), StationFlag::Interpolated), 10U);
  EXPECT_EQ(countOf(withGap(20, 11), StationFlag::Interpolated), 0U);
  EXPECT_EQ(countOf(withGap(20, 11), StationFlag::Missing), 11U);
  EXPECT_EQ(countOf(withGap(20, 11), StationFlag::Measured), 349U);
}

TEST(FlagGaps, AreThoseOfTheGapItself) {
  const auto stations = withGap(20, 9);
  EXPECT_EQ(stations[19].flag, StationFlag::Measured);
  EXPECT_EQ(stations[20].flag, StationFlag::Interpolated);
  EXPECT_EQ(stations[28].flag, StationFlag::Interpolated);
  EXPECT_EQ(stations[29].flag, StationFlag::Measured);
}

TEST(FlagGaps, GoRoundTheSeam) {
  const auto bridged = withGap(355, 10);
  EXPECT_EQ(bridged[359].flag, StationFlag::Interpolated);
  EXPECT_EQ(bridged[0].flag, StationFlag::Interpolated);
  EXPECT_EQ(bridged[5].flag, StationFlag::Measured);
  EXPECT_EQ(countOf(withGap(355, 11), StationFlag::Missing), 11U);
}

TEST(FlagGaps, TwoGapsAreJudgedEachByItsOwnLength) {
  std::vector<bool> supported(360, true);
  for (std::size_t i = 10; i < 15; ++i) supported[i] = false;
  for (std::size_t i = 100; i < 130; ++i) supported[i] = false;
  const std::vector<StationFlag> flags = flagsOf(supported, {});
  EXPECT_EQ(std::count(flags.begin(), flags.end(), StationFlag::Interpolated), 5);
  EXPECT_EQ(std::count(flags.begin(), flags.end(), StationFlag::Missing), 30);
}

TEST(FlagGaps, AllSupportedAreMeasuredAndNoneSupportedAreMissing) {
  EXPECT_EQ(countOf(withGap(0, 0), StationFlag::Measured), 360U);
  EXPECT_EQ(countOf(withGap(0, 360), StationFlag::Missing), 360U);
  EXPECT_EQ(countOf(withGap(0, 359), StationFlag::Missing), 359U);
}

TEST(FlagGaps, LongestBridgeIsAnOptionInRadians) {
  StationOptions options;
  options.longest_bridge = 20 * kDegree;
  EXPECT_EQ(countOf(withGap(20, 20, options), StationFlag::Interpolated), 20U);
  EXPECT_EQ(countOf(withGap(20, 21, options), StationFlag::Interpolated), 0U);
  options.longest_bridge = 0;
  EXPECT_EQ(countOf(withGap(20, 1, options), StationFlag::Missing), 1U);
  options.longest_bridge = 10 * kDegree;
  options.count = 36;
  EXPECT_EQ(countOf(withGap(2, 1, options), StationFlag::Interpolated), 1U);
  EXPECT_EQ(countOf(withGap(2, 2, options), StationFlag::Missing), 2U);
}

TEST(SamplePaperCurve, GivesTheCurveAtEveryStation) {
  for (const Station& s : Tank10().sample()) {
    EXPECT_EQ(s.flag, StationFlag::Measured);
    EXPECT_NEAR(s.z, Tank10::elevation(s.direction), 1e-5);
    EXPECT_NEAR(s.radius, 10.0, 1e-4);
    EXPECT_NEAR(s.x, kCenter.x() + 10 * std::cos(s.direction), 1e-4);
    EXPECT_NEAR(s.y, kCenter.y() + 10 * std::sin(s.direction), 1e-4);
    EXPECT_TRUE(std::isnan(s.sigma_z));
  }
}

TEST(SamplePaperCurve, FollowsZeroAzimuthAndDirection) {
  StationOptions options;
  options.zero_azimuth = 90 * kDegree;
  options.clockwise = true;
  const auto stations = Tank10().sample(options);
  EXPECT_NEAR(stations[0].y, kCenter.y() + 10, 1e-4);
  EXPECT_NEAR(stations[90].x, kCenter.x() + 10, 1e-4);
  EXPECT_NEAR(stations[30].z, Tank10::elevation(60 * kDegree), 1e-5);
}

TEST(SamplePaperCurve, FlagsWhereNoEdgePointsAre) {
  const auto bridged = Tank10(5, 356).sample();  // 356 .. 4: nine degrees
  EXPECT_EQ(countOf(bridged, StationFlag::Interpolated), 9U);
  EXPECT_NEAR(bridged[0].z, Tank10::elevation(0), 1e-3);
  const auto open = Tank10(0, 180).sample();
  EXPECT_EQ(countOf(open, StationFlag::Measured), 180U);
  EXPECT_EQ(countOf(open, StationFlag::Missing), 180U);
  EXPECT_TRUE(std::isnan(open[270].z));
  EXPECT_TRUE(std::isnan(open[270].x));
}

TEST(SamplePaperCurve, SupportLiesWithinHalfADegreeOrHalfASpacing) {
  StationOptions fine, coarse;
  fine.longest_bridge = coarse.longest_bridge = 0.0;
  fine.count = 720;
  EXPECT_EQ(countOf(Tank10(0.1, 360, 1.0).sample(fine), StationFlag::Measured), 720U);
  EXPECT_EQ(countOf(Tank10(0.1, 360, 2.0).sample(fine), StationFlag::Measured), 360U);  // 0 and 0.5 of 0, 0.5, 1, 1.5
  coarse.count = 36;
  EXPECT_EQ(countOf(Tank10(4.9, 360, 10.0).sample(coarse), StationFlag::Measured), 36U);
  EXPECT_EQ(countOf(Tank10(0, 360, 20.0).sample(coarse), StationFlag::Measured), 18U);
}

TEST(SamplePaperCurve, SupportReachesRoundTheSeam) {
  StationOptions options;
  options.longest_bridge = 0.0;
  const auto stations = Tank10(0.6, 360, 1.0).sample(options);  // nearest to station 0: 359.6
  EXPECT_EQ(stations[0].flag, StationFlag::Measured);
  options.zero_azimuth = -0.2 * kDegree;  // nearest to 359.8: 0.2
  EXPECT_EQ(Tank10(0.2, 360, 10.0).sample(options)[0].flag, StationFlag::Measured);
}

TEST(StationOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(StationOptions())), "");
  StationOptions options;
  options.count = 7;
  EXPECT_EQ(said(firstError(options)), "stations, 7, expected 8 to 36000");
  options.count = 36'001;
  EXPECT_NE(said(firstError(options)), "");
  options = {};
  options.zero_azimuth = INFINITY;
  EXPECT_EQ(said(firstError(options)), "zero_azimuth_deg, inf, expected -360 to 360 deg");
  options = {};
  options.longest_bridge = -0.5;
  EXPECT_EQ(said(firstError(options)), "longest_bridge_deg, -28.6479, expected >= 0 and < 360 deg");
  options.longest_bridge = NAN;
  EXPECT_NE(said(firstError(options)), "");
}

}  // namespace tank_datum::stations_test
