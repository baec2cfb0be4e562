#include <gtest/gtest.h>

#include "trust/tests_of_tank.h"

namespace tank_datum::unknown_shell_test {

/// What is asked of a wall that is seen in so many sectors, which no circle fits.
TankTest ofWall(std::size_t sectors) {
  ShellEvidence shell;
  shell.sectors = sectors;
  return testsOfShell(Tank(), shell).back();
}

TEST(TestsOfShell, OfAWallThatIsHardlySeenNothingIsKnown) {
  for (const std::size_t sectors : {0U, 7U, 40U}) {
    const TankTest test = ofWall(sectors);
    EXPECT_EQ(test.name, "wall");
    EXPECT_EQ(test.outcome, TestOutcome::Doubtful);
    EXPECT_EQ(test.value, sectors == 7 ? 7.0 : 0.0);
  }
  EXPECT_EQ(ofWall(0).limit, 8.0);
}

}  // namespace tank_datum::unknown_shell_test
