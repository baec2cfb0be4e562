// A shell under a dome, which is no part of it: walls of half to most of what is seen, and the shell's own circle.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/units.h"
#include "locate/tank_description.h"
#include "locate/wall_sector.h"
#include "support/made_faces.h"
#include "support/made_walls.h"

namespace tank_datum::dome_test {

using made_faces::addGround;
using made_faces::kRadius;

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

/// The radius described of a wall 6 m high that lies inside of the circle by what is given for each height.
double radiusOf(const std::function<double(double)>& inside) {
  Sample sample{{}, 0.1, false};
  for (int row = 0; row < 60; ++row) {
    const double z = 0.1 * row + 0.05, r = kRadius - inside(z);
    for (int i = 0; i < 720; ++i) {
      const double a = 0.5 * i * kDegree;
      sample.points.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  }
  addGround(sample.points, 0.0);
  return describe(sample.points, sample, {{0.0, 0.0}, kRadius - 0.05}, 0.03).circle.radius;
}

TEST(Describe, TheCircleUnderADomeIsTheShells) {
  EXPECT_NEAR(radiusOf([](double z) { return inwards(std::max(0.0, z - 2.5)); }), kRadius, 0.002);
  EXPECT_NEAR(radiusOf([](double) { return 0.0; }), kRadius, 1e-6) << "no dome";
}

TEST(Describe, TheCircleOfTheLowerHalfIsTakenAQuarterOfAVoxelAway) {
  const auto cone = [](double lean) { return radiusOf([lean](double z) { return lean * z; }); };
  EXPECT_NEAR(cone(0.013), kRadius - 0.013 * 3.0, 0.003) << "of the whole height";
  EXPECT_NEAR(cone(0.025), kRadius - 0.025 * 1.5, 0.006) << "of the lower half";
}

}  // namespace tank_datum::dome_test
