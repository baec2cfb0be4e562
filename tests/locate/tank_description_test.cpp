#include "locate/tank_description.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_faces.h"

namespace tank_datum::tank_description_test {

using namespace made_faces;

constexpr Side kOutside = Side::Outside;

/// The foot of a shell 4 m high above a face 0.4 m high that stands `off` outside of it.
double footAbove(double off) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 0.4, 4.4);
  addFace(sample.points, off, 0.0, 0.36);
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002).foot(1.0);
}

TEST(Describe, AFaceBelowTheShellIsARingwallsFrom75MillimetresOutside) {
  EXPECT_NEAR(footAbove(0.06), 0.0, 0.03);
  EXPECT_NEAR(footAbove(0.09), 0.4, 0.03);
  EXPECT_NEAR(footAbove(0.14), 0.4, 0.03);
}

/// The foot of a shell 5 m high of which a girder 1.2 m up hides 0.4 m; below it the shell is seen over so many
/// degrees.
double footUnderGirder(double degrees) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 1.2, 5.0);
  Points below;
  addFace(below, 0.0, 0.0, 0.8);
  for (const auto& p : below) {
    if (std::abs(std::atan2(p.y(), p.x())) < 0.5 * degrees * kDegree) sample.points.push_back(p);
  }
  addGround(sample.points, 1.2);
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002).foot(1.0);
}

TEST(Describe, AShellOfWhichMostGoesOnUnderAGirderBeginsThere) {
  EXPECT_NEAR(footUnderGirder(360.0), 0.0, 0.03);
  EXPECT_NEAR(footUnderGirder(200.0), 0.0, 0.03);
  EXPECT_NEAR(footUnderGirder(160.0), 1.2, 0.03);
}

/// What is seen of a shell 3 m high upon a ringwall of 1 m over so many degrees, by a circle that neither is on:
/// between the two, and as far off as they are.
Tank uponRingwall(double degrees) {
  constexpr double kWidth = 0.16;
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 1.0, 4.0);
  Points face;
  addFace(face, kWidth, 0.0, 0.99);
  for (const auto& p : face) {
    const double azimuth = std::atan2(p.y(), p.x());
    const bool ringwall = (azimuth < 0.0 ? azimuth + kTwoPi : azimuth) < degrees * kDegree;
    const double share = ringwall ? 1.0 : kRadius / (kRadius + kWidth);
    sample.points.emplace_back(share * p.x(), share * p.y(), p.z());
  }
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius + 0.5 * kWidth}, 0.5 * kWidth);
}

TEST(Describe, AShellUponARingwallIsFoundByItsStep) {
  const Tank tank = uponRingwall(360.0);
  EXPECT_NEAR(tank.foot(1.0), 1.0, 0.06);
  EXPECT_NEAR(tank.height, 3.0, 0.12);
  EXPECT_NEAR(tank.circle.radius, kRadius, 0.001);
  EXPECT_EQ(tank.side, kOutside);
  EXPECT_TRUE(tank.has_foundation);
}

TEST(Describe, AStepOverHalfTheShellIsARingwalls) {
  EXPECT_NEAR(uponRingwall(200.0).foot(1.0), 1.0, 0.06);
  EXPECT_NEAR(uponRingwall(160.0).foot(1.0), 0.0, 0.06);
}

/// What is seen, by the circle of its face, of a ringwall that stands out by 0.4 m, and of the shell above it: so much
/// over so many degrees.
Tank byItsFace(double shell, double degrees, bool given = false) {
  Sample sample{{}, 0.1, false};
  Points above;
  addFace(above, 0.0, 1.0, 1.0 + shell);
  for (const auto& p : above) {
    const double azimuth = std::atan2(p.y(), p.x());
    if ((azimuth < 0.0 ? azimuth + kTwoPi : azimuth) < degrees * kDegree) sample.points.push_back(p);
  }
  addFace(sample.points, 0.4, 0.0, 0.99);
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius + 0.4}, 0.002, kLeastFoundation, given);
}

TEST(Describe, AShellFarBehindTheFaceOfItsRingwallIsFound) {
  const Tank tank = byItsFace(0.6, 360.0);
  EXPECT_NEAR(tank.circle.radius, kRadius, 0.001);
  EXPECT_NEAR(tank.foot(1.0), 1.0, 0.06);
  EXPECT_NEAR(tank.height, 0.6, 0.12);
  EXPECT_NEAR(tank.ringwall_width, 0.4, 0.001);
  EXPECT_NEAR(tank.ringwall_height, 1.0, 0.2);
}

TEST(Describe, WhereAFaceOnlyIsSeenNothingTellsOfItsStep) {
  const Tank tank = byItsFace(0.6, 100.0);
  EXPECT_NEAR(tank.circle.radius, kRadius, 0.001);
  EXPECT_NEAR(tank.foot(1.0), 1.0, 0.06);
  EXPECT_NEAR(tank.coverage, 100.0 * kDegree, 5.0 * kDegree);
  EXPECT_FALSE(byItsFace(0.0, 360.0).standsOnRingwall());
}

TEST(Describe, AGivenCircleIsNotLeftForAnother) {
  const Tank tank = byItsFace(3.0, 360.0, true);
  EXPECT_NEAR(tank.circle.radius, kRadius + 0.4, 0.001);
  EXPECT_NEAR(tank.foot(1.0), 0.0, 0.06);
  EXPECT_FALSE(tank.standsOnRingwall());
}

/// What a wall so high says, behind which something lies so high over a half of it, as far in, by a circle seen from
/// outside.
/// @param rows_above  of the wall, a metre apart
double lowWallOf(double high, double behind, double far_in = 0.3, int rows_above = 0) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 0.0, high);
  for (int row = 1; row <= rows_above; ++row) addFace(sample.points, 0.0, high + row, high + row);
  addGround(sample.points, 0.0);
  for (double a = 0.0; a < 0.5 * kTwoPi; a += 0.006)
    for (double in = 0.3; in <= far_in; in += 0.1)
      sample.points.emplace_back((kRadius - in) * std::cos(a), (kRadius - in) * std::sin(a), behind);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002).low_wall;
}

TEST(Describe, BehindTheTopOfALowWallSomethingMayLie) {
  EXPECT_NEAR(lowWallOf(1.5, 1.4), 0.5, 0.02);
  EXPECT_NEAR(lowWallOf(1.9, 1.9), 0.5, 0.02);
  EXPECT_EQ(lowWallOf(1.5, 1.2), 0.0);
  EXPECT_TRUE(std::isnan(lowWallOf(2.2, 2.2)));
}

TEST(Describe, AWallThatGoesOnAboveInSparseRowsIsNotLow) {
  EXPECT_NEAR(lowWallOf(1.5, 1.5, 0.45, 1), 0.5, 0.02) << "two rows lie behind, as a ringwall's top";
  EXPECT_EQ(lowWallOf(1.5, 1.5, 0.45, 2), 0.0);
}

TEST(Describe, WhatGoesOnFartherInThanARingwallIsWideIsARoof) {
  EXPECT_NEAR(lowWallOf(1.5, 1.5, 0.55), 0.5, 0.02);
  EXPECT_EQ(lowWallOf(1.5, 1.5, 0.75), 0.0);
}

TEST(Describe, FromInsideNoRingwallIsSeen) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.4, 0.0, 1.0);
  addFace(sample.points, 0.0, 1.0, 2.0);
  for (double a = 0.0; a < kTwoPi; a += 0.006)
    sample.points.emplace_back((kRadius - 0.5) * std::cos(a), (kRadius - 0.5) * std::sin(a), 0.0);
  const Tank tank = describe(sample.points, sample, {{0.0, 0.0}, kRadius + 0.4}, 0.002);
  EXPECT_EQ(tank.side, Side::Inside);
  EXPECT_FALSE(tank.standsOnRingwall());
}

TEST(Describe, SaysWhereATankStandsAndWhatWasSeen) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 0.4, 4.4);
  addGround(sample.points, 0.3);
  const Tank tank = describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002);
  EXPECT_EQ(tank.side, kOutside);
  EXPECT_TRUE(tank.has_foundation);
  EXPECT_NEAR(tank.circle.radius, kRadius, 1e-9);
  EXPECT_NEAR(tank.coverage, kTwoPi, 1e-12);
  EXPECT_NEAR(tank.height, 4.0, 0.06);
}

/// Whether a shell has a foundation of which points lie beside so many degrees of it, in so many arcs.
bool hasFoundation(double degrees, double least, int arcs = 4) {
  Sample sample{{}, 0.1, false};
  addFace(sample.points, 0.0, 0.4, 4.4);
  for (int arc = 0; arc < arcs; ++arc) {
    for (double along = 0.0; along < degrees * kDegree / arcs; along += 0.006) {
      const double a = kTwoPi * arc / arcs + along;
      sample.points.emplace_back((kRadius + 0.5) * std::cos(a), (kRadius + 0.5) * std::sin(a), 0.3);
    }
  }
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002, least).has_foundation;
}

TEST(Describe, AFoundationIsSeenOverAShareOfTheShell) {
  EXPECT_TRUE(hasFoundation(100.0, 0.25));
  EXPECT_FALSE(hasFoundation(80.0, 0.25));
  EXPECT_TRUE(hasFoundation(200.0, 0.5));
  EXPECT_FALSE(hasFoundation(160.0, 0.5));
}

/// The same of one arc beside a shell of 1.2 m radius, whose sectors are of 14 degrees.
bool hasFoundationOfSmall(double degrees) {
  constexpr double kSmall = 1.2;
  Sample sample{{}, 0.1, false};
  for (double a = 0.0; a < kTwoPi; a += 0.02) {
    for (double z = 0.4; z <= 4.4; z += 0.06) sample.points.emplace_back(kSmall * std::cos(a), kSmall * std::sin(a), z);
    if (a < degrees * kDegree)
      sample.points.emplace_back((kSmall + 0.5) * std::cos(a), (kSmall + 0.5) * std::sin(a), 0.3);
  }
  return describe(sample.points, sample, {{0.0, 0.0}, kSmall}, 0.002).has_foundation;
}

TEST(Describe, AFoundationIsSeenInFourSectorsAtLeast) {
  EXPECT_FALSE(hasFoundationOfSmall(40.0));
  EXPECT_TRUE(hasFoundationOfSmall(55.0));
}

TEST(Describe, AFoundationIsSeenInOneArc) {
  EXPECT_TRUE(hasFoundation(35.0, 0.25, 1));
  EXPECT_FALSE(hasFoundation(25.0, 0.25, 1));
  EXPECT_TRUE(hasFoundation(65.0, 0.5, 1));
  EXPECT_FALSE(hasFoundation(55.0, 0.5, 1));
}

/// The foot in the middle of 40 degrees on which a shell of 4 m is seen down to height 0; elsewhere from `from` on.
double footOfArc(double from) {
  Sample sample{{}, 0.1, false};
  Points shell;
  addFace(shell, 0.0, 0.0, 4.0);
  for (const auto& p : shell) {
    if (p.z() > from || std::abs(std::atan2(p.y(), p.x())) < 20.0 * kDegree) sample.points.push_back(p);
  }
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius}, 0.002).foot(0.0);
}

TEST(Describe, TheFootIsNoFartherAboveALowArcThanIsCroppedBelowIt) {
  EXPECT_NEAR(footOfArc(0.15), 0.16, 0.03);
  EXPECT_NEAR(footOfArc(0.5), 0.3, 0.03);
  EXPECT_NEAR(footOfArc(0.8), 0.3, 0.03);
}

}  // namespace tank_datum::tank_description_test
