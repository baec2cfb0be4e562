// A shell under a dome, which is no part of it: walls of a third to most of what is seen.

#include <gtest/gtest.h>

#include <cmath>

#include "locate/wall_sector.h"
#include "support/made_walls.h"

namespace tank_datum::dome_test {

constexpr double kRadius = 10.0;  // [m]

/// How far a hemisphere of the shell's radius lies inside of it so far above its spring [m].
double inwards(double above) { return kRadius - std::sqrt(kRadius * kRadius - above * above); }

TEST(ShellRun, BeginsAtItsFootUnderADome) {
  for (const double wall : {1.5, 2.5, 4.0}) {
    std::vector<Hit> hits;
    made_walls::stack(hits, 0.0, wall, 0.0);
    for (double above = 0.05; inwards(above) < 0.4; above += 0.05) hits.push_back({wall + above, -inwards(above)});
    const auto run = shellRun(hits, made_walls::kVoxel, made_walls::kThickness);
    ASSERT_TRUE(run) << wall;
    EXPECT_NEAR(run->bottom, 0.0, 1e-9) << wall;
    EXPECT_GT(run->top, wall);
  }
}

TEST(ShellRun, LineUnderADomeIsOfALeanBeyondAShells) {
  const auto bottom = [](double lean) {
    std::vector<Hit> hits;
    made_walls::stack(hits, 0.0, 2.0, 0.0);
    made_walls::stack(hits, 2.0, 6.0, -2.0 * lean, lean);
    return shellRun(hits, made_walls::kVoxel, made_walls::kThickness)->bottom;
  };
  EXPECT_EQ(bottom(-0.06), 0.0) << "a dome's";
  EXPECT_GT(bottom(-0.045), 0.3) << "its lowest third is another's";
}

}  // namespace tank_datum::dome_test
