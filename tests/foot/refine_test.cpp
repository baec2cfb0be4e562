#include <gtest/gtest.h>

#include <cmath>

#include "support/refined_scans.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::refine_test {

using namespace refined_scans;

/// 65 mm of plate on a ringwall, a weld in the corner, soil over thirty degrees of it and, with sudden
/// ends, over fifteen.
SceneOptions plateScene() {
  SceneOptions scene = tank20();
  scene.tanks[0].foundation.kind = "annular_plate";
  scene.tanks[0].foundation.weld = 0.006;
  scene.tanks[0].soil = {{radians(100), radians(30), 0.05, 0.3, 0.3, 0.004, 0.03},
                         {radians(210), radians(15), 0.03, 0.25, 0.05, 0.002, 0.03}};
  scene.scanner.row_step = radians(0.05);
  return scene;
}
const Scanned& plateRun() {
  static const Scanned result = run(plateScene(), pointsOf(plateScene()));
  return result;
}

void expectAccurate(const Scanned& scanned) {
  EXPECT_LT(scanned.rms, 0.0005);
  EXPECT_LT(scanned.largest, 0.002);
  EXPECT_GE(scanned.within_2_sigma, 0.80);
}

TEST(RefineStations, OfAPadAreTheTruthToAFractionOfAMillimetre) {
  expectAccurate(padRun());
  EXPECT_EQ(padRun().measured, 360U);
  EXPECT_EQ(padRun().refined.profile.surface, Surface::Foundation);
  EXPECT_LT(padRun().within_2_sigma, 1.0);  // not by inflating sigma
  for (const Station& s : padRun().stations) {
    EXPECT_LT(s.sigma_z, 3.0 * padRun().rms);
    EXPECT_GT(s.n_shell.value_or(0), 10U);
    EXPECT_GT(s.n_foundation.value_or(0), 3U);
  }
}

TEST(RefineStations, TheCircleIsFoundFromMillimetresBeside) {
  const Refined& refined = padRun().refined;
  EXPECT_TRUE(refined.valid());
  EXPECT_LT(refined.circle.center.norm(), 0.0002);
  EXPECT_NEAR(refined.circle.radius, 10.0, 0.0002);
  EXPECT_GT(refined.sigma_radius, 0.0);
  EXPECT_LT(refined.sigma_radius, 0.0001);
  for (const Station& s : padRun().stations) {
    const Eigen::Vector2d arm = Eigen::Vector2d(s.x, s.y) - refined.circle.center;
    EXPECT_NEAR(arm.norm(), s.radius, 1e-9);
    EXPECT_NEAR(std::remainder(std::atan2(arm.y(), arm.x()) - s.direction, kTurn), 0.0, 1e-9);
    EXPECT_NEAR(s.radius, 10.0, 6.0 * s.sigma_radius + 0.0001);
  }
}

TEST(RefineStations, OnAPlateAreTheTruthAndNamedSo) {
  expectAccurate(plateRun());
  EXPECT_EQ(plateRun().refined.profile.surface, Surface::AnnularPlate);
  EXPECT_LE(plateRun().refined.profile.band_to, 0.065);
  EXPECT_GE(plateRun().measured, 310U);
}

TEST(RefineStations, OnSoilAreNotMeasuredOrRightWhereItFadesOut) {
  std::size_t covered = 0, measured = 0;
  for (const Station& s : plateRun().stations) {
    if (!plateRun().truthAt(s).covered) continue;
    ++covered;
    if (s.flag == StationFlag::Missing) {
      EXPECT_TRUE(std::isnan(s.z));
      EXPECT_TRUE(std::isnan(s.sigma_z));
      continue;
    }
    ++measured;
    EXPECT_LT(std::abs(s.z - plateRun().truthAt(s).z), 2.0 * s.sigma_z) << degrees(s.direction);
  }
  EXPECT_GT(covered, 20U);
  EXPECT_LE(measured, 3U);  // where the heap fades out
}

TEST(RefineStations, UnseenArcsAreMissingAndShortOnesBridged) {
  Points seen;
  for (const auto& p : padPoints()) {
    const double a = degrees(std::atan2(p.y(), p.x()));
    if ((a > 50.5 && a < 55.5) || (a > 110.5 && a < 150.5)) continue;
    seen.push_back(p);
  }
  const Scanned scanned = run(tank20(), seen);
  expectAccurate(scanned);
  EXPECT_NEAR(static_cast<double>(scanned.measured), 315.0, 2.0);
  for (std::size_t i = 112; i < 150; ++i) {
    EXPECT_EQ(scanned.stations[i].flag, StationFlag::Missing) << i;
    EXPECT_TRUE(std::isnan(scanned.stations[i].z)) << i;
  }
  for (std::size_t i = 52; i < 55; ++i) {
    const Station& s = scanned.stations[i];
    EXPECT_EQ(s.flag, StationFlag::Interpolated) << i;
    EXPECT_NEAR(s.z, scanned.truthAt(s).z, 4.0 * s.sigma_z) << i;
    EXPECT_GT(s.sigma_z, padRun().stations[i].sigma_z) << i;
  }
}

TEST(RefineStations, ClockwiseFromAnotherZeroAreTheSame) {
  StationOptions options;
  options.zero_azimuth = radians(90);
  options.clockwise = true;
  const Scanned turned = run(tank20(), padPoints(), {}, options);
  expectAccurate(turned);
  for (std::size_t i = 0; i < 360; ++i) {
    const Station& same = padRun().stations[(90 + 360 - i) % 360];
    EXPECT_NEAR(turned.stations[i].direction, same.direction, 1e-9) << i;
    EXPECT_NEAR(turned.stations[i].z, same.z, 1e-5) << i;
    EXPECT_NEAR(turned.stations[i].radius, same.radius, 1e-6) << i;
  }
}

TEST(RefineStations, FewerStationsAreAsTrue) {
  StationOptions options;
  options.count = 90;
  const Scanned scanned = run(tank20(), padPoints(), {}, options);
  EXPECT_EQ(scanned.measured, 90U);
  EXPECT_LT(scanned.rms, 0.0005);
}

TEST(RefineStations, SoAreVeryFew) {
  StationOptions options;
  for (const int count : {8, 36, 72}) {
    options.count = count;
    EXPECT_EQ(run(tank20(), padPoints(), {}, options).measured, static_cast<std::size_t>(count));
  }
}

TEST(RefineStations, FromInsideMeetTheFloor) {
  SceneOptions scene = tank20();
  scene.tanks[0].foundation.weld = 0.006;
  scene.tanks[0].floor_cone = 0.008;
  scene.scanner.inside = true;
  scene.scanner.count = 3, scene.scanner.distance = 3.0;
  scene.scanner.step = radians(0.2);
  const Scanned scanned = run(scene, pointsOf(scene));
  expectAccurate(scanned);
  EXPECT_EQ(scanned.measured, 360U);
  EXPECT_NEAR(scanned.refined.circle.radius, 9.988, 0.0002);  // the inner face
  EXPECT_NEAR(scanned.refined.profile.slope, 0.008, 0.002);
}

TEST(RefineStations, OfAShellAloneAreNotValid) {
  Points shell;
  for (const auto& p : padPoints()) {
    if (p.head<2>().norm() < 10.006 && p.z() > 0.03) shell.push_back(p);
  }
  const Scanned scanned = run(tank20(), shell);
  EXPECT_FALSE(scanned.refined.valid());
  EXPECT_EQ(scanned.measured, 0U);
}

}  // namespace tank_datum::refine_test
