#include "locate/step_back.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_walls.h"

namespace tank_datum::step_back_test {

using namespace made_walls;

/// The height at which a wall 4 m high steps back upon a face that stands out so far; one that leans, whose hits are
/// off it by so much to either side.
double stepBack(double face, double out, double lean = 0.0, double scatter = 0.0, double top = 4.0) {
  std::vector<Hit> hits;
  stack(hits, 0.0, face, out, lean);
  stack(hits, face, top, 0.0, lean);
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i].off += i % 2 == 0 ? scatter : -scatter;
  return findStepBack(hits, kVoxel, kThickness).height;
}

TEST(StepBackHeight, IsWhereAShellStandsBackFromTheFaceOfItsRingwall) {
  EXPECT_NEAR(stepBack(1.0, 0.15), 1.0, 0.5 * kVoxel);
  EXPECT_NEAR(stepBack(1.0, 0.15, 0.03), 1.0, 0.5 * kVoxel);
  EXPECT_NEAR(stepBack(1.0, 0.15, -0.03), 1.0, 0.5 * kVoxel);
}

/// The height at which an upright wall steps back upon a face 1 m high that leans by so much.
double stepBackOfBattered(double lean, double crest) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.0, crest - lean, lean);
  stack(hits, 1.0, 4.0, 0.0);
  return findStepBack(hits, kVoxel, kThickness).height;
}

TEST(StepBackHeight, AFaceMayBeBattered) {
  EXPECT_NEAR(stepBackOfBattered(-0.1, 0.12), 1.0, 0.5 * kVoxel);
  EXPECT_NEAR(stepBackOfBattered(-0.2, 0.12), 1.0, 0.5 * kVoxel);
  EXPECT_TRUE(std::isnan(stepBackOfBattered(-0.1, 0.0)));  // a wall that bends has no step
  EXPECT_TRUE(std::isnan(stepBackOfBattered(0.1, 0.0)));
}

TEST(StepBackHeight, IsNoneOfAWallThatLeansOrStandsOutAbove) {
  EXPECT_TRUE(std::isnan(stepBack(1.0, 0.0, -0.05)));
  EXPECT_TRUE(std::isnan(stepBack(1.0, -0.15)));
}

TEST(StepBackHeight, IsNoneOfLessThanARingwallStandsOut) {
  EXPECT_TRUE(std::isnan(stepBack(1.0, 0.070)));
  EXPECT_NEAR(stepBack(1.0, 0.080), 1.0, 0.5 * kVoxel);
}

TEST(StepBackHeight, IsTwoMetresAtTheMost) {
  EXPECT_NEAR(stepBack(1.9, 0.15, 0.0, 0.0, 5.0), 1.9, 0.5 * kVoxel);
  EXPECT_TRUE(std::isnan(stepBack(2.4, 0.15, 0.0, 0.0, 5.0)));
}

TEST(StepBackHeight, BothPiecesAreThreeVoxelsHigh) {
  EXPECT_TRUE(std::isnan(stepBack(0.2, 0.15)));
  EXPECT_NEAR(stepBack(0.4, 0.15), 0.4, 0.5 * kVoxel);
  EXPECT_TRUE(std::isnan(stepBack(0.6, 0.15, 0.0, 0.0, 0.8)));
  EXPECT_NEAR(stepBack(0.6, 0.15, 0.0, 0.0, 1.05), 0.6, 0.5 * kVoxel);
}

TEST(StepBackHeight, HitsLieNearTheirPieces) {
  EXPECT_NEAR(stepBack(1.0, 0.100, 0.0, 0.017), 1.0, 0.5 * kVoxel);
  EXPECT_TRUE(std::isnan(stepBack(1.0, 0.100, 0.0, 0.024)));
}

TEST(StepBackHeight, AGirderNearTheTopIsNoFace) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.2, 0.0);
  stack(hits, 1.2, 1.5, 0.2);
  stack(hits, 1.5, 3.0, 0.0);
  EXPECT_FALSE(findStepBack(hits, kVoxel, kThickness).found());
  EXPECT_FALSE(findStepBack({}, kVoxel, kThickness).found());
}

TEST(StepBackHeight, TheGroundBeforeAFaceAndTheTopOfARingwallAreNoWall) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.0, 0.3);
  stack(hits, 1.02, 4.0, 0.0);
  for (double off = -0.02; off < 0.6; off += 0.04) {
    hits.push_back({-0.02, off}), hits.push_back({-0.06, off});
    if (off < 0.3) hits.push_back({1.0, off});
  }
  const StepBack step = findStepBack(hits, kVoxel, kThickness);
  EXPECT_NEAR(step.height, 1.0, 0.5 * kVoxel);
  EXPECT_NEAR(step.off, 0.0, 0.005);
  EXPECT_NEAR(step.width, 0.3, 0.01);
  EXPECT_NEAR(step.bottom, 0.0, 0.05);
  EXPECT_NEAR(step.top, 3.95, 0.05);
}

/// Whether a wall steps back that leans by so much upon a face that stands out by 0.6 m.
bool stepsBackLeaning(double lean) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.0, 0.6);
  stack(hits, 1.0, 1.4, -lean, lean);
  return findStepBack(hits, kVoxel, kThickness).found();
}

TEST(StepBackHeight, WhatLeansByHalfAMetreInAMetreIsARoof) {
  EXPECT_TRUE(stepsBackLeaning(-0.45));
  EXPECT_FALSE(stepsBackLeaning(-0.55));
  EXPECT_FALSE(stepsBackLeaning(-5.0));
}

/// Whether a wall steps back of which so many hits are seen 0.15 m above a face 1 m high.
bool stepsBackSeenBy(int hits_above) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.0, 0.15);
  for (int i = 0; i < hits_above; ++i) hits.push_back({1.15, 0.0});
  return findStepBack(hits, 0.03, kThickness).found();
}

TEST(StepBackHeight, ASingleHitAboveMayLieOnARoof) {
  EXPECT_FALSE(stepsBackSeenBy(1));
  EXPECT_TRUE(stepsBackSeenBy(2));
}

/// The height of a step of 1 m upon which the shell is first seen so much higher.
double stepBelowHidden(double hidden) {
  constexpr double kFine = 0.03;
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.05, 0.2);
  stack(hits, 1.0 + hidden, 3.0, 0.0);
  return findStepBack(hits, kFine, kThickness).height;
}

TEST(StepBackHeight, AQuarterOfAMetreOfTheShellMayBeHidden) {
  EXPECT_NEAR(stepBelowHidden(0.24), 1.12, 0.01);
  EXPECT_TRUE(std::isnan(stepBelowHidden(0.28)));
  EXPECT_TRUE(std::isnan(stepBelowHidden(0.49)));
}

}  // namespace tank_datum::step_back_test
