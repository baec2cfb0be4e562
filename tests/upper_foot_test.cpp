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

/// A datum upon a step that stands out by so much, a metre above the ground.
Datum datumUpon(double width, Surface surface = Surface::Foundation, double edge = 0.0) {
  Datum datum = datumAt(0.0, Status::Ok, surface);
  datum.tank.ringwall_width = width, datum.tank.ringwall_height = 1.0;
  datum.refined.profile.edge = edge;
  return datum;
}

TEST(StepInDoubt, IsOneThatMayBeTheEdgeOfWhatCladsAShell) {
  EXPECT_EQ(stepInDoubt(datumAt(0.0, Status::Ok), {}).height, 0.0);
  EXPECT_EQ(stepInDoubt(datumUpon(0.1), {}).height, 1.0);
  EXPECT_EQ(stepInDoubt(datumUpon(0.1), {}).width, 0.1);
  EXPECT_EQ(stepInDoubt(datumUpon(0.115), {}).height, 0.0) << "few claddings are as thick";
}

TEST(StepInDoubt, IsNoneBeyondALip) {
  EXPECT_EQ(stepInDoubt(datumUpon(0.1, Surface::AnnularPlate, 0.075), {}).height, 0.0);
  EXPECT_EQ(stepInDoubt(datumUpon(0.1, Surface::AnnularPlate, 0.085), {}).height, 1.0)
      << "the lip's edge is the step's";
  EXPECT_EQ(stepInDoubt(datumUpon(0.1, Surface::Ringwall, 0.05), {}).height, 1.0);
}

/// Whether a step 0.1 m wide is in doubt where so many bins beyond it, of 10 mm, lie so far below the foot.
bool isInDoubtBefore(std::size_t bins, double low) {
  Datum datum = datumUpon(0.1);
  FootProfile& profile = datum.refined.profile;
  profile.bin = 0.01;
  profile.height.assign(50, kUnknown);
  for (std::size_t i = 0; i < 12; ++i) profile.height[i] = 0.0;
  for (std::size_t i = 12; i < 12 + bins; ++i) profile.height[i] = -low;
  return stepInDoubt(datum, {}).height > 0.0;
}

TEST(StepInDoubt, IsNoneWhereAFoundationGoesOnBeyondItAtSomeAzimuths) {
  EXPECT_TRUE(isInDoubtBefore(4, 0.0));
  EXPECT_FALSE(isInDoubtBefore(5, 0.0));
  EXPECT_FALSE(isInDoubtBefore(5, 0.045));
  EXPECT_TRUE(isInDoubtBefore(5, 0.055));
}

TEST(StepInDoubt, OfALowerWallIsTheStepAboveItUnlessThatStandsOnAPlate) {
  const Tank upon = datumUpon(0.05).tank;
  EXPECT_EQ(stepInDoubt(datumAt(0.0, Status::Partial), upon).height, 1.0);
  EXPECT_EQ(stepInDoubt(datumAt(0.0, Status::Partial), upon).width, 0.05);
  EXPECT_EQ(stepInDoubt(datumAt(0.0, Status::Ok, Surface::AnnularPlate), upon).height, 0.0);
  EXPECT_EQ(stepInDoubt(datumAt(0.0, Status::NoCrease), upon).height, 0.0) << "refused for another reason";
}

TEST(IsOfFace, WhatIsNearerToIt) {
  Tank upon;
  upon.circle = {{0.0, 0.0}, 10.0}, upon.ringwall_width = 0.1;
  EXPECT_FALSE(isOfFace(10.04, upon));
  EXPECT_TRUE(isOfFace(10.06, upon));
}

}  // namespace tank_datum::upper_foot_test
