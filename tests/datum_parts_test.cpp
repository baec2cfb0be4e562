#include <gtest/gtest.h>

#include <utility>

#include "datum_status.h"
#include "foot_frame.h"
#include "locate/foot_unit.h"
#include "refusals.h"

namespace tank_datum::datum_parts_test {

TEST(WarningsOf, ARadiusOfMoreThanAHundredMetresIsOfAScanInOtherUnits) {
  const auto warned = [](double radius) {
    Datum datum;
    datum.circle.radius = radius;
    const auto warnings = warningsOf(datum);
    return warnings.empty() ? std::string() : warnings.front();
  };
  EXPECT_EQ(warned(95.0), "");
  EXPECT_EQ(warned(105.0), "R = 105 m: is the scan in ft or mm?");
  EXPECT_EQ(warned(5000.0), "R = 5000 m: is the scan in mm?");
}

TEST(WarningsOf, AShellSeenTwentyCentimetresAboveTheHeightGivenIsTold) {
  const auto warned = [](double seen) {
    Datum datum;
    datum.asked_height = 10.0;
    datum.shell.points.resize(1);
    datum.shell.points[0].height = seen;
    return !warningsOf(datum).empty();
  };
  EXPECT_FALSE(warned(10.15));
  EXPECT_TRUE(warned(10.25));
}

TEST(WarningsOf, SetupsThatAreOffAreNamedWhereTheirPointsTellOfTheShell) {
  Datum datum;
  datum.agreement.setups.resize(3);
  datum.agreement.covariance = Eigen::MatrixXd::Identity(15, 15);
  for (auto& setup : datum.agreement.setups) setup.name = "scan" + std::to_string(&setup - &datum.agreement.setups[0]);
  datum.agreement.setups[1].correction.dx = 0.020;
  datum.shell.points.resize(1);
  EXPECT_TRUE(warningsOf(datum).empty());
  datum.agreement.setups[1].verdict = SetupVerdict::Bad;
  ASSERT_EQ(warningsOf(datum).size(), 1U);
  EXPECT_EQ(warningsOf(datum)[0],
            "roundness and plumbness are of the points as they are registered, off by up to 20 mm in plan (scan1): "
            "leave those out to have them of the others");
  datum.shell.points.clear();
  EXPECT_TRUE(warningsOf(datum).empty());
}

TEST(EndDatum, CoordinatesInStepsOfAMillimetreAreTold) {
  const auto message = [](double step) {
    Datum datum;
    datum.coordinate_step = step;
    return endDatum(datum, Status::NoTank, "").message;
  };
  EXPECT_EQ(message(0.0008), "");
  EXPECT_EQ(message(0.001), "");  // the usual scale of LAS
  EXPECT_EQ(message(0.0015), "its coordinates have steps of 1.5 mm here: store 8-byte ones, or a finer scale");
}

TEST(DoubtfulUnits, NoTankHasTwoHundredMetresOfDiameterInFeetNoneTwoThousand) {
  EXPECT_EQ(doubtfulUnits(95.0), "");
  EXPECT_EQ(doubtfulUnits(950.0), "R = 950 m: is the scan in ft or mm?");
  EXPECT_EQ(doubtfulUnits(1050.0), "R = 1050 m: is the scan in mm?");
}

TEST(LeanText, AShellThatLeansByATenthOfADegreeIsToldOneThatLeansByLessIsNot) {
  const auto text = [](double slope, double sigma) {
    Datum datum;
    datum.lean.slope = {slope, 0.0};
    datum.lean.sigma = sigma;
    return leanText(datum, {});
  };
  EXPECT_EQ(text(0.0016, 1e-5), "");
  EXPECT_EQ(text(0.0019, 1e-5), "the shell leans by 0.11 deg towards 0 deg");
  EXPECT_EQ(text(0.0019, 0.0005), "") << "within four standard errors";
}

TEST(FootFrame, AShellThatLeansByMoreThanAQuarterOfADegreeAndFourSigmasIsTurnedUpright) {
  const auto turned = [](double slope, double sigma) {
    Tank tank;
    tank.circle = {{0.0, 0.0}, 10.0};
    tank.foot.coefficients = Eigen::Vector3d::Zero();
    return !FootFrame(tank, {{slope, 0.0}, sigma}).isScans();
  };
  EXPECT_FALSE(turned(0.0040, 1e-5));
  EXPECT_TRUE(turned(0.0048, 1e-5));
  EXPECT_TRUE(turned(0.0090, 0.0020));
  EXPECT_FALSE(turned(0.0090, 0.0025));
}

TEST(FootFrame, ATankThatIsTurnedUprightHasTheCircleOfItsFoot) {
  const auto moved = [](double slope) {
    Tank tank;
    tank.circle = {{0.1, 0.0}, 10.0};
    tank.foot.coefficients = Eigen::Vector3d::Zero();
    ShellEvidence evidence;
    evidence.circle = {{0.02, 0.0}, 10.0};
    evidence.at_foot = {{0.01, 0.0}, 10.0};
    evidence.lean = {{slope, 0.0}, 1e-5};
    return onItsFoot(std::move(tank), evidence).circle.center.x();
  };
  EXPECT_EQ(moved(0.03), 0.01);
  EXPECT_EQ(moved(0.004), 0.1);
}

TEST(FootFrame, WhatWasMeasuredAboutALeaningShellIsTurnedBackAndScaled) {
  Tank tank;
  tank.circle = {{3.0, -1.0}, 200.0};  // 20 m long metres
  tank.foot.coefficients = Eigen::Vector3d(5.0, 0.0, 0.0);
  const FootFrame frame(tank, {{0.02, 0.0}, 1e-5});
  Ring ring;
  ring.points = {{203.0, -1.0, 5.0}, {203.0, -1.0, 5.4}};
  const Points inside = frame.into(ring).points;
  FootResult foot;
  foot.circle = frame.into(tank).circle;
  foot.stations.resize(2);
  for (Station& s : foot.stations) {
    s.direction = 0.0;
    s.z_refused = inside[1].z();
  }
  foot.stations[0].x = inside[0].x();  // measured; of the other nothing is known
  foot.stations[0].y = inside[0].y();
  foot.stations[0].z = inside[0].z();
  foot.refined.profile.unseen = 0.01;
  frame.backFrom(foot);
  EXPECT_NEAR(foot.stations[0].z, 5.0, 1e-9);
  for (const Station& s : foot.stations) EXPECT_NEAR(s.z_refused, 5.4, 0.001);
  EXPECT_DOUBLE_EQ(foot.refined.profile.unseen, 0.2);
}

TEST(FootUnit, IsAMetreFromADrumToTheLargestTank) {
  EXPECT_EQ(footUnit(1.05, 0.001), 1.0);
  EXPECT_EQ(footUnit(95.0, 0.001), 1.0);
}

TEST(FootUnit, ThatOfAnythingElseMakesItATankOfTenMetres) {
  EXPECT_DOUBLE_EQ(footUnit(0.95, 0.001), 0.095);
  EXPECT_DOUBLE_EQ(footUnit(105.0, 0.001), 10.5);
  EXPECT_DOUBLE_EQ(footUnit(30000.0, 5.0), 3000.0);
}

TEST(FootUnit, IsAMetreForTinsSeenByFewerThanSixtyPointsToARadius) {
  EXPECT_EQ(footUnit(0.5, 0.5 / 55.0), 1.0);
  EXPECT_DOUBLE_EQ(footUnit(0.5, 0.5 / 65.0), 0.05);
}

}  // namespace tank_datum::datum_parts_test
