// Which of the tanks found a datum is of, and what is said where there is none.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>

#include "sighting.h"
#include "support/made_clouds.h"
#include "tank_datum/core/error.h"
#include "tank_datum/datum.h"

namespace tank_datum::datum_pick_test {

using namespace made_clouds;

TEST(ExtractDatum, SmallestRadiusDecidesWhetherThereIsATank) {
  DatumOptions options;
  options.locate.min_radius = 6.0;
  EXPECT_EQ(extractDatum(Scan::fromPoints(tankPoints()), options).status, Status::NoTank);
}

TEST(ExtractDatum, OfATankThatIsNotThereKeepsOriginAndCounts) {
  DatumOptions options;
  options.pick = 5;
  const Scan scan = Scan::fromPoints(tankPoints({1000, 2000, 50}));
  std::size_t found = 0;
  const Datum datum =
      extractDatum(scan, options, {{}, [&](const std::vector<Tank>& tanks) { found = tanks.size(); }, {}});
  EXPECT_EQ(found, 1U);
  EXPECT_EQ(datum.status, Status::NoTank);
  EXPECT_EQ(datum.message, "only 1 found, no tank 5 to pick");
  EXPECT_EQ(datum.origin, scan.origin());
  EXPECT_EQ(datum.counts.points, scan.size());
}

/// Two of the made tank, 40 m apart, that lean by so much.
Points twoTanks(double first_degrees, double second_degrees) {
  Points points;
  for (const auto& [at, degrees] : {std::pair{0.0, first_degrees}, std::pair{40.0, second_degrees}}) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(degrees * kTurn / 360.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
    for (const Eigen::Vector3d& p : tankPoints()) points.push_back(turn * p + Eigen::Vector3d(at, 0.0, 0.0));
  }
  return points;
}

TEST(ExtractDatum, ATankThatIsTurnedUprightIsTheOnePicked) {
  const Scan scan = Scan::fromPoints(twoTanks(1.0, 0.5));  // turned, the second one is found first
  DatumOptions options;
  options.pick = 2;
  const Datum leaning = extractDatum(scan, options);
  options.level = true;
  const Datum upright = extractDatum(scan, options);
  const Eigen::Vector2d there = leaning.tank.circle.center + leaning.origin.head<2>();
  EXPECT_NEAR((upright.tank.circle.center + upright.origin.head<2>() - there).norm(), 0.0, 0.1);
}

/// A leaning tank's points, rounded to a step [m], turned upright.
Datum levelled(double step) {
  Points points = twoTanks(1.0, 1.0);
  for (Eigen::Vector3d& p : points) p = (p / step).array().round() * step;
  DatumOptions options;
  options.level = true;
  return extractDatum(Scan::fromPoints(points), options);
}

TEST(ExtractDatum, WhatWasRoundedCoarselyIsNotTurnedUpright) {
  EXPECT_NO_THROW(levelled(0.001));
  try {
    levelled(0.002);
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Option);
    EXPECT_NE(std::string(error.what()).find("rounded to 2 mm"), std::string::npos) << error.what();
  }
}

TEST(ExtractDatum, OfNoTankIsThatOfAScanWithoutOne) {
  const Scan scan = Scan::fromPoints(floorPoints(50'000, 8.0));
  ASSERT_TRUE(findTanks(scan, {}).empty());
  const Datum datum = extractDatum(Tank(), scan, {}), whole = extractDatum(scan, {});
  EXPECT_EQ(datum.status, Status::NoTank);
  EXPECT_EQ(datum.message, whole.message);
  EXPECT_EQ(datum.counts.points, scan.size());
}

/// What is said of a foot of which a scan holds so much, and so many of whose points, a share, are farther in or out.
std::string saidOfCut(double outside, double farther_in = 0.0, double farther_out = 0.0) {
  constexpr double kRadius = 8.0;
  constexpr int kPoints = 4000;  // a picture shows them all
  Points points;
  for (int i = 0; i < kPoints; ++i) {
    const double azimuth = 0.01 * i, share = 0.01 * (i % 100);
    double off = i % 2 == 0 ? 0.0 : outside * share;
    if (i < farther_in * kPoints) off = -3.0;
    if (i >= (1.0 - farther_out) * kPoints) off = 3.0;
    points.push_back(
        {(kRadius + off) * std::cos(azimuth), (kRadius + off) * std::sin(azimuth), off == 0.0 ? share : 0.0});
  }
  Datum datum;
  datum.status = Status::NoCrease;
  const Scan scan = Scan::fromPoints(points);
  datum.tank.circle = {-scan.origin().head<2>(), kRadius};
  return withSighting(std::move(datum), scan, {}).message;
}

TEST(WithSighting, AScanCutNearItsShellIsTold) {
  EXPECT_EQ(saidOfCut(0.16), "the scan ends 0.16 m outside of the shell: what it stands on was cut off");
  EXPECT_EQ(saidOfCut(0.25), "");
  EXPECT_NE(saidOfCut(0.16, 0.04), "");
  EXPECT_EQ(saidOfCut(0.16, 0.07), "") << "seen from inside, or from above";
  EXPECT_NE(saidOfCut(0.16, 0.0, 0.0008), "") << "strays";
  EXPECT_EQ(saidOfCut(0.16, 0.0, 0.0013), "");
}

}  // namespace tank_datum::datum_pick_test
