#include "upper_foot.h"

#include <gtest/gtest.h>

#include "core/units.h"

namespace tank_datum::upper_foot_test {

/// A datum at a height, of a tank whose foot is there.
Datum datumAt(double height, Status status, Surface surface = Surface::Foundation) {
  Datum datum;
  datum.status = status;
  datum.tank.circle = {{0.0, 0.0}, 10.0};
  datum.tank.foot.coefficients = Eigen::Vector3d(height, 0.0, 0.0);
  datum.refined.profile.surface = surface;
  for (int i = 0; i < 12; ++i) {
    Station& s = datum.stations.emplace_back();
    s.direction = i * kTwoPi / 12.0;
    s.z = height;
  }
  return datum;
}

/// Which one is taken of one at height 0 and of one so far below it.
double chosen(Status upper, Status lower, double below, Surface surface) {
  return upperOrLower(datumAt(0.0, upper), datumAt(-below, lower, surface)).stations.front().z;
}

TEST(UpperOrLower, AShellStandsOnThePlateThatItHasWellBelowAStep) {
  EXPECT_EQ(chosen(Status::Ok, Status::Ok, 0.07, Surface::AnnularPlate), -0.07);
  EXPECT_EQ(chosen(Status::Ok, Status::Partial, 0.05, Surface::AnnularPlate), 0.0);
}

TEST(UpperOrLower, WithoutAPlateItStandsOnTheStep) {
  EXPECT_EQ(chosen(Status::Ok, Status::Ok, 0.4, Surface::Foundation), 0.0);
  EXPECT_EQ(chosen(Status::Partial, Status::Ok, 0.4, Surface::Ringwall), 0.0);
}

TEST(UpperOrLower, WhatIsRefusedOrDoubtfulIsNone) {
  for (const Status none : {Status::NoCrease, Status::FitFailed, Status::Doubtful}) {
    EXPECT_EQ(chosen(none, Status::Partial, 0.4, Surface::Foundation), -0.4);
    EXPECT_EQ(chosen(Status::Partial, none, 0.4, Surface::AnnularPlate), 0.0);
  }
}

TEST(UpperOrLower, OfTwoThatAreNoneTheOneWithStationsIsShownElseTheLower) {
  EXPECT_EQ(chosen(Status::Doubtful, Status::NoCrease, 0.4, Surface::Foundation), 0.0);
  EXPECT_EQ(chosen(Status::NoCrease, Status::Doubtful, 0.4, Surface::Foundation), -0.4);
  EXPECT_EQ(chosen(Status::Doubtful, Status::Doubtful, 0.4, Surface::Foundation), -0.4);
  EXPECT_EQ(chosen(Status::NoCrease, Status::NoCrease, 0.4, Surface::Foundation), -0.4);
}

}  // namespace tank_datum::upper_foot_test
