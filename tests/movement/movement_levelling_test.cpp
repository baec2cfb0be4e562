#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "levelling.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/movement/movement.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::movement_levelling_test {

double shapeAt(double direction) { return 1.0 + 0.006 * std::cos(2.0 * direction) + 0.004 * std::sin(3.0 * direction); }

/// A survey of a 30 m tank with stations `step` degrees apart.
Epoch scanned(double step = 1.0, double lift = 0.0) {
  Epoch epoch{"scan", "ok", "refined", "foundation", {{500.0, -80.0}, 30.0}, {}};
  for (double a = 0.0; a < 359.99; a += step) {
    const double direction = a * kDegree;
    epoch.stations.push_back({direction, direction, shapeAt(direction) + lift, 0.0003, 2 * kDegree});
  }
  return epoch;
}

/// The same tank levelled, with azimuths from 10 degrees on.
Epoch levelled(double step = 20.0, double lift = 0.0, double first = 10.0) {
  Epoch epoch = scanned(step, lift);
  epoch.name = "levelling", epoch.surface.clear(), epoch.levelled = true, epoch.circle.center = {0.0, 0.0};
  for (Elevation& e : epoch.stations) {
    e.azimuth += first * kDegree, e.direction += first * kDegree;
    e.z = shapeAt(e.direction) + lift, e.sigma_z = 0.0005, e.window = NAN;
  }
  return epoch;
}

std::string refusal(const Epoch& a, const Epoch& b) {
  return refusalOf(Error::Kind::Option, [&] { compareEpochs(a, b, {}); });
}

/// Options of heights that hang on the same benchmarks to 0.2 mm.
MovementOptions tied() {
  MovementOptions options;
  options.removal = Removal::Nothing;
  options.registration_error = 0.0002;
  return options;
}

TEST(LevellingAgainstScan, IsComparedAtTheLevelledStationsBothWays) {
  const Movement later = compareEpochs(levelled(), scanned(1.0, -0.004), tied());
  EXPECT_EQ(later.matched, 18U);
  EXPECT_EQ(later.significant, 18U);
  EXPECT_NEAR(later.max, -0.004, 1e-9);
  const Movement earlier = compareEpochs(scanned(1.0, -0.004), levelled(), tied());
  EXPECT_EQ(earlier.matched, 18U);
  EXPECT_EQ(earlier.stations.size(), 18U);
  EXPECT_NEAR(earlier.max, 0.004, 1e-9);
}

TEST(LevellingAgainstScan, NeedsNoStationsAtWholeDegrees) {
  for (const double step : {20.0, 360.0 / 14.0}) {
    const Movement m = compareEpochs(levelled(step, 0.0, 0.4), scanned(1.0, -0.004), tied());
    EXPECT_EQ(m.matched, static_cast<std::size_t>(std::lround(360.0 / step)));
    ASSERT_EQ(m.stations.size(), m.matched);
    EXPECT_NEAR(m.stations[1].azimuth, (step + 0.4) * kDegree, 1e-9);
    EXPECT_NEAR(m.stations[1].dz, -0.004, 3e-6);  // the scan's interpolation
    EXPECT_NEAR(m.stations[1].sigma_baseline, 0.0005, 1e-12);
    EXPECT_NEAR(m.stations[1].sigma, std::hypot(std::hypot(0.0005, 0.0003, 0.0001), 0.0002), 1e-9);
  }
}

TEST(LevellingAgainstScan, GivesAzimuthsAsTheScanCountsThem) {
  Epoch clockwise = scanned();
  for (Elevation& e : clockwise.stations) e.azimuth = std::remainder(90 * kDegree - e.direction, 360 * kDegree);
  MovementOptions turned;
  turned.azimuth_offset = 5 * kDegree;
  Epoch before = levelled(20.0, 0.0, 0.4);
  for (Elevation& e : before.stations) e.z = shapeAt(e.direction - 5 * kDegree);
  const Movement m = compareEpochs(before, clockwise, turned);
  EXPECT_EQ(m.matched, 18U);
  EXPECT_NEAR(m.rms, 0.0, 3e-6);
  EXPECT_NEAR(m.stations[1].direction, 20.4 * kDegree, 1e-9);
  EXPECT_NEAR(m.stations[1].azimuth, (90 - 15.4) * kDegree, 1e-9);
}

TEST(LevellingAgainstScan, FindsTheTurnByTheShape) {
  MovementOptions options;
  options.estimate_offset = true;
  Epoch before = levelled(10.0, 0.0, 0.4);
  for (Elevation& e : before.stations) e.z = shapeAt(e.direction - 37 * kDegree);
  const Movement m = compareEpochs(before, scanned(), options);
  EXPECT_EQ(m.matched, 36U);
  EXPECT_NEAR(m.azimuth_offset, 37 * kDegree, 0.5 * kDegree);
}

TEST(LevellingAgainstScan, WhereTheRodStandsIsNoMovement) {
  for (const bool scan_first : {false, true}) {
    const Epoch level = levelled(), scan = scanned(1.0, 0.15);
    const Movement m = scan_first ? compareEpochs(scan, level, {}) : compareEpochs(level, scan, {});
    EXPECT_EQ(m.removal, Removal::Mean);
    EXPECT_TRUE(m.rod_taken_out);
    EXPECT_EQ(m.significant, 0U);
    EXPECT_FALSE(m.moved());
    EXPECT_NEAR(m.rms, 0.0, 1e-9);
    EXPECT_NEAR(m.mean, scan_first ? -0.15 : 0.15, 1e-9);
  }
  EXPECT_EQ(compareEpochs(levelled(), scanned(), tied()).removal, Removal::Nothing);
  EXPECT_EQ(compareEpochs(levelled(), levelled(), {}).removal, Removal::Nothing);
  MovementOptions none;
  none.removal = Removal::Nothing;
  EXPECT_NEAR(compareEpochs(levelled(), scanned(1.0, 0.15), none).max, 0.15, 1e-9) << "as it was asked for";
  EXPECT_FALSE(compareEpochs(scanned(), scanned(), {}).rod_taken_out);
}

TEST(LevellingAgainstScan, OneLevellingTakesTheMeanOutOfTheWholeCourse) {
  const std::vector<Movement> course =
      compareWithFirst({scanned(), levelled(20.0, 0.15), scanned(1.0, -0.004)}, MovementOptions());
  ASSERT_EQ(course.size(), 2U);
  for (const Movement& m : course) EXPECT_EQ(m.removal, Removal::Mean);
  EXPECT_TRUE(course[0].rod_taken_out);
  EXPECT_TRUE(course[1].rod_taken_out);
  EXPECT_NEAR(course[1].rms, 0.0, 1e-9);
  MovementOptions tilt;
  tilt.removal = Removal::Tilt;
  EXPECT_EQ(compareWithFirst({scanned(), levelled()}, tilt).front().removal, Removal::Tilt);
  EXPECT_FALSE(compareWithFirst({scanned(), levelled()}, tilt).front().rod_taken_out);
  EXPECT_NEAR(compareWithFirst({scanned(), scanned(1.0, -0.004)}, {}).front().max, -0.004, 1e-9);
}

TEST(LevellingAgainstScan, HasARadiusButNeitherCentreNorSurfaceInCommon) {
  EXPECT_EQ(refusal(levelled(), scanned()), "");
  EXPECT_EQ(refusal(scanned(), levelled()), "");
  EXPECT_EQ(refusal(levelled(), levelled()), "");
  Epoch wider = levelled();
  wider.circle.radius = 30.2;
  EXPECT_NE(refusal(wider, scanned()).find("radius of scan"), std::string::npos);
  EXPECT_NE(refusal(scanned(), wider).find("radius of levelling"), std::string::npos);
  Epoch elsewhere = scanned();
  elsewhere.circle.center.x() += 1.0;
  EXPECT_NE(refusal(scanned(), elsewhere).find("centre of scan"), std::string::npos);
}

TEST(LevellingAgainstScan, WithoutStandardErrorsIsRefusedWithTheColumnThatLacks) {
  Epoch bare = levelled();
  for (Elevation& e : bare.stations) e.sigma_z = NAN;
  for (const std::string& said : {refusal(bare, scanned()), refusal(scanned(), bare), refusal(bare, levelled())}) {
    EXPECT_NE(said.find("standard errors of levelling, none"), std::string::npos) << said;
    EXPECT_NE(said.find("sigma column"), std::string::npos) << said;
  }
  for (std::size_t i = 0; i < 8; ++i) bare.stations[i].sigma_z = 0.0005;
  EXPECT_EQ(compareEpochs(bare, scanned(), {}).matched, 8U);
  bare.stations[0].sigma_z = NAN;
  const Movement few = compareEpochs(bare, scanned(), {});
  EXPECT_FALSE(few.valid());
  EXPECT_EQ(few.message, "only 7 stations are measured in both surveys, and 8 are needed");
}

TEST(EpochOf, ALevellingKeepsThatItIsOne) {
  std::vector<Station> stations = levellingStations(
      "azimuth_deg,elevation,sigma\n0,1,0.001\n90,1,0.001\n180,1,\n270,1,0.001\n", "t.csv", 1.0, 60.0, {});
  const Datum datum = datumOfLevelling(std::move(stations), 60.0, DatumOptions());
  const Epoch epoch = epochOf(datum, Method::Refined, "levelling");
  EXPECT_TRUE(epoch.levelled);
  EXPECT_EQ(epoch.surface, "");
  EXPECT_EQ(epoch.judgeable(), 3U);
  EXPECT_FALSE(epochOf(Datum(), Method::Refined, "scan").levelled);
}

}  // namespace tank_datum::movement_levelling_test
