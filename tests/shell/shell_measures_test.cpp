#include "shell/shell_measures.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::shell_measures_test {

Roundness at(double height, double out, double gap) {
  Roundness r;
  r.height = height;
  r.max_deviation = out, r.min_deviation = -0.5 * out;
  r.sigma = 0.0002, r.azimuth = 1.0, r.widest_gap = gap;
  return r;
}

ShellSurvey survey() {
  ShellSurvey shell;
  shell.points.resize(1);
  shell.roundness = {at(0.3, 0.010, 1.0), at(1.3, 0.020, 8.0), at(2.3, 0.015, 1.0)};
  Plumbness plumb;
  plumb.height = 8.0, plumb.offset = -0.03, plumb.sigma = 0.001, plumb.azimuth = 2.0;
  shell.plumbness.assign(360, plumb);
  for (std::size_t i = 0; i < 360; ++i) shell.plumbness[i].direction = toRadians(static_cast<double>(i) - 90.0);
  return shell;
}

constexpr double kRadius = 20.0;

/// Whether plumbness is of the whole ring where so many degrees are seen over no more than so much of 8 m.
bool isWhole(std::size_t degrees, double seen, double tank_height = kUnknown) {
  ShellSurvey shell = survey();
  for (std::size_t i = 0; i < degrees; ++i) shell.plumbness[100 + i].height = seen;
  TankFacts facts;
  facts.height = tank_height;
  return shellMeasures(shell, facts, kRadius)[2].whole_ring;
}

TEST(ShellMeasures, AreTheFootTheWorstAboveAndTheWorstPlumbness) {
  const auto measures = shellMeasures(survey(), {}, kRadius);
  ASSERT_EQ(measures.size(), 3U);
  EXPECT_EQ(measures[0].quantity, "roundness_foot");
  EXPECT_EQ(measures[0].worst.value, 0.010);
  EXPECT_TRUE(measures[0].whole_ring);
  EXPECT_EQ(measures[1].quantity, "roundness_above");
  EXPECT_EQ(measures[1].worst.value, 0.020);
  EXPECT_FALSE(measures[1].whole_ring);
  EXPECT_EQ(measures[1].note, "1.30 m above the datum");
  EXPECT_EQ(measures[2].quantity, "plumbness");
  EXPECT_EQ(measures[2].worst.value, 0.03);
}

TEST(ShellMeasures, APartOfTheHeightLeavesPlumbnessOpen) {
  TankFacts facts;
  facts.height = 16.0;
  EXPECT_FALSE(shellMeasures(survey(), facts, kRadius)[2].whole_ring);
  facts.height = 8.5;
  EXPECT_TRUE(shellMeasures(survey(), facts, kRadius)[2].whole_ring);
}

TEST(ShellMeasures, AnArcAsWideAsSurveyPointsAreApartLeavesPlumbnessOpen) {  // 6.096 m are 17.5 degrees
  EXPECT_TRUE(isWhole(16, 4.0));
  EXPECT_FALSE(isWhole(17, 4.0));
  EXPECT_TRUE(isWhole(17, 7.3)) << "nearly all of the height";
  EXPECT_FALSE(isWhole(17, 7.1));
  EXPECT_FALSE(isWhole(17, 7.3, 8.5)) << "of the height that is said";
  EXPECT_TRUE(isWhole(17, 7.7, 8.5));
}

TEST(ShellMeasures, PlumbnessInOnePlaceIsNotOfTheRing) {
  ShellSurvey shell = survey();
  shell.plumbness.resize(1);
  EXPECT_FALSE(shellMeasures(shell, {}, kRadius)[2].whole_ring);
}

TEST(ShellMeasures, NothingOfAShellNotSeen) { EXPECT_TRUE(shellMeasures({}, {}, kRadius).empty()); }

}  // namespace tank_datum::shell_measures_test
