#include "foot/shell_strip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tank_datum::shell_strip_test {

constexpr double kReach = 0.5;

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> made;
  for (int i = 0; i < count; ++i) made.push_back(from + (to - from) * (i + 0.5) / count);
  return made;
}

/// Nothing from the shell to where the surface is seen, 60 mm off, and a shell that ends 12 mm above it.
struct Scene {
  double density = 1000.0;        ///< points on the surface [1/m]
  double share = 0.0;             ///< of as many, beside the shell
  double to = 0.06;               ///< where the surface is seen [m]
  double ends = 0.012;            ///< the shell, above the surface [m]
  double shell_density = 4000.0;  ///< points on it [1/m]

  double unseen() const {
    ShellStrip strip;
    strip.from = 0.002, strip.to = to;
    strip.width = 0.25, strip.surface = 0.25 * density;
    for (const double d : evenly(strip.from, to, static_cast<int>(std::lround(share * density * (to - strip.from)))))
      strip.points.push_back({d, 0.0});
    strip.shell = evenly(ends, 0.05, static_cast<int>(std::lround(shell_density * (0.05 - ends))));
    return unseenHeight(strip, kReach);
  }
};

TEST(UnseenHeight, IsWhereTheShellEnds) {
  EXPECT_NEAR(Scene().unseen(), 0.012, 0.0002);
  EXPECT_EQ(unseenHeight({}, kReach), 0.0);
}

TEST(UnseenHeight, IsNoneWhereTheSurfaceIsSeenBesideTheShell) {
  Scene scene;
  scene.share = 0.2;
  EXPECT_GT(scene.unseen(), 0.0) << "mixed pixels";
  scene.share = 0.3;
  EXPECT_EQ(scene.unseen(), 0.0);
}

TEST(UnseenHeight, IsNoneOfWhatMayBeChance) {
  Scene scene;
  scene.density = 16.0 / 0.058;
  EXPECT_GT(scene.unseen(), 0.0);
  scene.density = 10.0 / 0.058;
  EXPECT_EQ(scene.unseen(), 0.0);
  scene = {};
  scene.shell_density = 20.0 / 0.012;
  EXPECT_GT(scene.unseen(), 0.0);
  scene.shell_density = 10.0 / 0.012;
  EXPECT_EQ(scene.unseen(), 0.0);
}

TEST(UnseenHeight, IsNoneWhereNoLipWouldFit) {
  Scene scene;
  scene.density = 1e4;
  scene.to = 0.010;
  EXPECT_GT(scene.unseen(), 0.0);
  scene.to = 0.008;
  EXPECT_EQ(scene.unseen(), 0.0);
  scene = {};
  scene.shell_density = 4e4;
  scene.ends = 0.003;
  EXPECT_GT(scene.unseen(), 0.0);
  scene.ends = 0.002;
  EXPECT_EQ(scene.unseen(), 0.0);
}

}  // namespace tank_datum::shell_strip_test
