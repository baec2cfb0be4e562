#include "shell/shell_measures.h"

#include <gtest/gtest.h>

#include <cmath>
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
  shell.roundness = {at(0.3, 0.010, 1.0), at(1.3, 0.020, 8.0), at(2.3, 0.0, 1.0), at(4.9, 0.0, 1.0),
                     at(7.3, 0.015, 1.0)};
  Plumbness plumb;
  plumb.height = 7.7, plumb.top = 8.0, plumb.offset = -0.03, plumb.sigma = 0.001, plumb.azimuth = 2.0;
  shell.plumbness.assign(360, plumb);
  for (std::size_t i = 0; i < 360; ++i) shell.plumbness[i].direction = toRadians(static_cast<double>(i) - 90.0);
  return shell;
}

constexpr double kRadius = 20.0;

/// Whether plumbness is of the whole ring where so many degrees are seen over no more than so much of 8 m.
bool isWhole(std::size_t degrees, double seen, double tank_height = kUnknown) {
  ShellSurvey shell = survey();
  for (std::size_t i = 0; i < degrees; ++i)
    shell.plumbness[100 + i].top = seen, shell.plumbness[100 + i].height = seen - 0.3;
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

TEST(ShellMeasures, ARadiusIsSurelyWhatWasSeenAndMayBeMoreBetween) {
  ShellSurvey shell = survey();
  Roundness& worst = shell.roundness[1];
  worst.rise = 0.002, worst.sigma = std::hypot(0.0002, 0.002);
  const auto interval = [&] { return shellMeasures(shell, {}, kRadius)[1].interval; };
  EXPECT_NEAR(interval().low, 0.018 - 1.96 * 0.0002, 1e-6);
  EXPECT_NEAR(interval().high, 0.020 + 1.96 * 0.0022, 1e-6);
  worst.may_rise = 0.007;
  EXPECT_NEAR(interval().high, 0.027 + 1.96 * 0.0002, 1e-6);
  shell.roundness[4].may_rise = 0.020;  // of a height that shows less
  EXPECT_NEAR(interval().high, 0.035 + 1.96 * 0.0002, 1e-6);
  EXPECT_NEAR(shellMeasures(shell, {}, kRadius)[0].interval.high, 0.010 + 1.96 * 0.0002, 1e-6);
}

TEST(ShellMeasures, RadiiAboveAreOfTheRingThatIsSeenUpToNearlyItsHeight) {
  ShellSurvey shell = survey();
  shell.roundness[1].widest_gap = 1.0;
  TankFacts facts;
  const auto above = [&] { return shellMeasures(shell, facts, kRadius)[1]; };
  EXPECT_TRUE(above().whole_ring);
  facts.height = 8.2;  // 7.3 m are 89 %
  EXPECT_FALSE(above().whole_ring);
  EXPECT_EQ(above().note, "1.30 m above the datum; seen all round up to 7.3 m");
  facts.height = 8.1;
  EXPECT_TRUE(above().whole_ring);
  shell.roundness[3].widest_gap = 6.2;
  EXPECT_FALSE(above().whole_ring) << "nothing is known of 2.3 to 7.3 m";
  shell.roundness[2].height = 4.4;
  EXPECT_FALSE(above().whole_ring) << "nor of 1.3 to 4.4 m";
  shell.roundness[1].height = 1.5;
  EXPECT_TRUE(above().whole_ring) << "no more than a course each";
  shell.roundness[4].widest_gap = 6.2;
  EXPECT_FALSE(above().whole_ring) << "the ring is seen up to 4.4 m alone";
}

/// Of a tank so high, seen all round up to so far.
std::vector<Measure> ofLowTank(double height, double top) {
  ShellSurvey shell = survey();
  shell.roundness = {at(0.3, 0.010, 1.0), at(top, 0.015, 1.0)};
  for (Plumbness& p : shell.plumbness) p.top = top, p.height = top - 0.3;
  TankFacts facts;
  facts.height = height;
  return shellMeasures(shell, facts, kRadius);
}

TEST(ShellMeasures, ALowTankIsSeenUpToItsTopWhereTheNextHeightIsAboveIt) {
  for (const std::size_t k : {1U, 2U}) {
    EXPECT_TRUE(ofLowTank(3.25, 2.8)[k].whole_ring) << k;
    EXPECT_FALSE(ofLowTank(3.35, 2.8)[k].whole_ring) << k;
    EXPECT_FALSE(ofLowTank(8.0, 7.1)[k].whole_ring) << "a tenth is more";
  }
}

TEST(ShellMeasures, AnArcThatIsFarthestOffIsTheFigureAbove) {
  ShellSurvey shell = survey();
  shell.roundness[1].widest_gap = 1.0;
  shell.arcs = {at(7.8, 0.100, 20.0)};
  const Measure above = shellMeasures(shell, {}, kRadius)[1];
  EXPECT_EQ(above.worst.value, 0.100);
  EXPECT_TRUE(above.whole_ring) << "what else there is, is seen";
  shell.roundness[4].height = 5.3;
  EXPECT_FALSE(shellMeasures(shell, {}, kRadius)[1].whole_ring);
}

/// The interval of plumbness, 30 +- 1 mm at 8 m, of a tank that is so high and leans as a whole by so much.
Interval95 plumbness(double height, double slope) {
  ShellSurvey shell = survey();
  shell.lean.gradient = {slope, 0.0}, shell.lean.sigma = 1e-4;
  TankFacts facts;
  facts.height = height;
  return shellMeasures(shell, facts, kRadius)[2].interval;
}

TEST(ShellMeasures, PlumbnessMayGoOnAboveWhatIsSeen) {
  EXPECT_NEAR(plumbness(7.7, 0.0).high, 0.030 + 1.96 * 0.001, 1e-5);
  EXPECT_NEAR(plumbness(8.5, 0.0).high, (0.030 + 1.96 * 0.001) * 8.5 / 7.7, 1e-5);
  EXPECT_NEAR(plumbness(8.5, 0.0).low, 0.030 - 1.96 * 0.001, 1e-5);
}

TEST(ShellMeasures, PlumbnessMayBeLargestElsewhereWhereNearlyAllIsSeen) {
  ShellSurvey shell = survey();
  const auto high = [&] { return shellMeasures(shell, {}, kRadius)[2].interval.high; };
  const double worst = high();
  shell.plumbness[7].height = 7.0, shell.plumbness[7].top = 7.3, shell.plumbness[7].offset = 0.029;
  EXPECT_NEAR(high(), 8.0 / 7.0 * (0.029 + 1.96 * 0.001), 1e-5);
  shell.plumbness[7].height = 0.5, shell.plumbness[7].top = 0.8;
  EXPECT_EQ(high(), worst) << "half a metre tells nothing of the top";
}

TEST(ShellMeasures, BelowTheTopSurelyOutOfPlumbIsWhatTheWholeTankLeansBy) {
  EXPECT_EQ(plumbness(12.0, 0.0).low, 0.0);
  EXPECT_NEAR(plumbness(12.0, 0.003).low, 7.7 * (0.003 - 1.96e-4), 1e-5);
  EXPECT_NEAR(plumbness(12.0, 0.01).low, 0.030 - 1.96 * 0.001, 1e-5);
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

TEST(ShellMeasures, FromADentUpToTheTopIsNotTheShellsPlumbness) {
  ShellSurvey shell = survey();
  shell.plumbness[7].offset = 0.09;
  const auto low = [&] { return shellMeasures(shell, {}, kRadius)[2].interval.low; };
  shell.plumbness[7].height = 7.0;  // of 7.7
  EXPECT_NEAR(low(), 0.09 - 1.96 * 0.001, 1e-5);
  shell.plumbness[7].height = 6.8;
  EXPECT_EQ(low(), 0.0);
}

TEST(ShellMeasures, PlumbnessInOnePlaceIsNotOfTheRing) {
  ShellSurvey shell = survey();
  shell.plumbness.resize(1);
  EXPECT_FALSE(shellMeasures(shell, {}, kRadius)[2].whole_ring);
}

TEST(ShellMeasures, NothingOfAShellNotSeen) { EXPECT_TRUE(shellMeasures({}, {}, kRadius).empty()); }

}  // namespace tank_datum::shell_measures_test
