#include "locate/wall_sector.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_walls.h"

namespace tank_datum::wall_sector_test {

using namespace made_walls;

struct Stretch {
  bool wall = false;
  double bottom = 0, top = 0, under = 0;
};

Stretch runOf(const std::vector<Hit>& hits) {
  Stretch run;
  if (const auto found = shellRun(hits, kVoxel, kThickness)) run = {true, found->bottom, found->top, found->under};
  return run;
}

TEST(ShellRun, IsTheLongestStretchWithoutAHole) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 1.0, 0.0);
  stack(hits, 2.0, 5.0, 0.0);
  const Stretch run = runOf(hits);
  ASSERT_TRUE(run.wall);
  EXPECT_NEAR(run.bottom, 2.0, 1e-9);
  EXPECT_NEAR(run.top, 4.95, 1e-9);
}

TEST(ShellRun, GoesOnUnderWhatGirdersHide) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 0.7, 0.0);
  stack(hits, 1.2, 2.0, 0.0);
  stack(hits, 2.4, 5.0, 0.0);
  EXPECT_NEAR(runOf(hits).bottom, 2.4, 1e-9);
  EXPECT_NEAR(runOf(hits).under, 0.0, 1e-9);
  hits.clear();
  stack(hits, 0.0, 0.7, 0.0);
  stack(hits, 1.5, 4.0, 0.0);
  EXPECT_NEAR(runOf(hits).under, 1.5, 1e-9) << "the hole is higher than what lies below it";
}

TEST(ShellRun, LeavesOutTheFaceOfARingwallBelowTheShell) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 0.7, 0.15);
  stack(hits, 0.7, 4.0, 0.0);
  const Stretch run = runOf(hits);
  ASSERT_TRUE(run.wall);
  EXPECT_NEAR(run.bottom, 0.7, 1e-9);
}

TEST(ShellRun, FollowsAShellThatLeans) {
  std::vector<Hit> hits;
  stack(hits, 0.0, 10.0, -0.1, 0.02);
  const Stretch run = runOf(hits);
  ASSERT_TRUE(run.wall);
  EXPECT_NEAR(run.bottom, 0.0, 1e-9);
}

TEST(ShellRun, IsNoWallBelowThreeVoxels) {
  std::vector<Hit> hits;
  EXPECT_FALSE(runOf(hits).wall);
  stack(hits, 0.0, 0.25, 0.0);
  EXPECT_FALSE(runOf(hits).wall);
}

TEST(SectorsOf, TellsTheShellFromWhatLiesBesideIt) {
  const Circle circle{{1.0, 2.0}, 10.0};
  const Points points = {{11.05, 2.0, 3.0}, {11.9, 2.0, 0.5}, {10.1, 2.0, 0.25}, {14.0, 2.0, 9.0}};
  const auto sectors = sectorsOf(points, kVoxel, circle, 0.15);
  EXPECT_GE(sectors.size(), 24U);
  ASSERT_EQ(sectors[0].shell.size(), 1U);
  EXPECT_NEAR(sectors[0].shell[0].z, 3.0, 1e-12);
  EXPECT_NEAR(sectors[0].shell[0].off, 0.05, 1e-12);
  EXPECT_EQ(sectors[0].outside, std::vector<double>{0.5});
  EXPECT_EQ(sectors[0].inside, std::vector<double>{0.25});
}

TEST(HasFoundation, IsWhatLiesAboutAsHighAsTheFoot) {
  EXPECT_TRUE(hasFoundation({3.0, -0.2}, 0.0, kVoxel, 10.0));
  EXPECT_FALSE(hasFoundation({3.0, -2.0}, 0.0, kVoxel, 10.0));
  EXPECT_FALSE(hasFoundation({}, 0.0, kVoxel, 10.0));
}

/// How many points that lie this far outside of a band of 0.02 m are beside the shell.
std::size_t besideAt(double off) {
  const auto sectors = sectorsOf(Points(1, {10.02 + off, 0.0, 0.0}), 0.01, {{0.0, 0.0}, 10.0}, 0.02);
  return sectors[0].outside.size();
}

TEST(SectorsOf, OnTopOfTheNarrowestRingwallNothingIsBeside) {
  EXPECT_EQ(besideAt(0.09), 0U);
  EXPECT_EQ(besideAt(0.11), 1U);
}

/// How many points that lie this far off a circle are around the shell.
std::size_t aroundAt(double off, double radius) {
  const auto sectors = sectorsOf(Points(1, {radius + off, 0.0, 0.0}), 0.01, {{0.0, 0.0}, radius}, 0.02);
  return sectors[0].around.size();
}

TEST(SectorsOf, AroundTheShellIsWhatARingwallMayReach) {
  EXPECT_EQ(aroundAt(0.59, 10.0), 1U);
  EXPECT_EQ(aroundAt(-0.59, 10.0), 1U);
  EXPECT_EQ(aroundAt(0.61, 10.0), 0U);
  EXPECT_EQ(aroundAt(0.19, 1.0), 1U);
  EXPECT_EQ(aroundAt(0.21, 1.0), 0U);
}

TEST(HasFoundation, TheGroundMayDropHalfAMetreAtARingwall) {
  constexpr double kFine = 0.001;
  EXPECT_TRUE(hasFoundation({-0.49}, 0.0, kFine, 10.0));
  EXPECT_FALSE(hasFoundation({-0.52}, 0.0, kFine, 10.0));
}

}  // namespace tank_datum::wall_sector_test
