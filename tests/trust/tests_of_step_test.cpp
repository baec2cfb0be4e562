#include <gtest/gtest.h>

#include "trust/tests_of_tank.h"

namespace tank_datum::tests_of_step_test {

constexpr double kReach = 0.5;

TestOutcome outcomeAt(double height) {
  const std::vector<TankTest> tests = testsOfStep(0.06, height, kReach);
  EXPECT_EQ(tests.size(), 1U);
  return tests.front().outcome;
}

TEST(TestsOfStep, OneHigherThanAKerbIsDoubtfulAndNeverMore) {
  EXPECT_EQ(outcomeAt(0.39), TestOutcome::Pass);
  EXPECT_EQ(outcomeAt(0.41), TestOutcome::Doubtful);
  EXPECT_EQ(outcomeAt(2.0), TestOutcome::Doubtful);
}

TEST(TestsOfStep, SaysWhereItIs) {
  const std::string finding = testsOfStep(0.06, 0.9, kReach).front().finding;
  EXPECT_EQ(finding.find("its wall steps back by 0.06 m, 0.9 m above the ground, "), 0U) << finding;
}

TEST(TestsOfStep, AreNoneWithoutAStep) { EXPECT_TRUE(testsOfStep(0.0, 0.0, kReach).empty()); }

}  // namespace tank_datum::tests_of_step_test
