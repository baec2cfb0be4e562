#include "locate/narrow_ringwall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum::narrow_ringwall_test {

constexpr double kRadius = 10.0;

/// A shell on a ringwall.
struct Scene {
  double width = 0.05;    ///< how far the ringwall stands out [m]
  double height = 0.15;   ///< above the ground [m]
  double scatter = 0.0;   ///< of the points about shell and face [m]
  double straight = 0.0;  ///< share of the ring where the shell goes straight down
  double hidden = 0.0;    ///< share where all is hidden up to a quarter of a metre above the foot
  std::function<double(double)> face = [](double) { return 0.0; };  ///< what it stands out less, by height [m]
};

/// The tank as it is found in the sample: its foot on the ground.
Tank foundTank(const Scene& scene) {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d(-scene.height, 0.0, 0.0);
  tank.resolution = 0.05;
  return tank;
}

Ring ringOf(const Scene& scene) {
  Ring ring;
  ring.reach = 0.5;
  int number = 0;
  for (int i = 0; i < 1440; ++i) {
    const double azimuth = (i + 0.5) * kTwoPi / 1440.0;
    const bool hides = azimuth > (1.0 - scene.hidden) * kTwoPi;
    const auto add = [&](double off, double z) {
      if (hides && z < 0.25) return;
      const double radius = kRadius + off + (++number % 2 == 0 ? scene.scatter : -scene.scatter);
      ring.points.push_back({radius * std::cos(azimuth), radius * std::sin(azimuth), z});
    };
    const double width = azimuth < scene.straight * kTwoPi ? 0.0 : scene.width;
    for (double z = 0.005; z < 0.5 - scene.height; z += 0.01) add(0.0, z);
    for (double z = -0.005; z > -scene.height; z -= 0.01) add(width == 0.0 ? 0.0 : width - scene.face(z), z);
    for (double d = width + 0.01; d < 0.4; d += 0.02) add(d, -scene.height);
  }
  return ring;
}

std::optional<Tank> upon(const Scene& scene) { return onNarrowRingwall(ringOf(scene), {}, foundTank(scene)); }

TEST(NarrowRingwall, TheShellBeginsWhereItStepsBack) {
  const std::optional<Tank> tank = upon({});
  ASSERT_TRUE(tank);
  EXPECT_NEAR(tank->foot(1.0), 0.0, 0.006);
  EXPECT_NEAR(tank->circle.radius, kRadius, 0.001);
  EXPECT_NEAR(tank->ringwall_width, 0.05, 0.002);
  EXPECT_NEAR(tank->ringwall_height, 0.15, 0.015);
  EXPECT_FALSE(onNarrowRingwall(ringOf({}), {}, *tank));  // which is known now
}

TEST(NarrowRingwall, IsNarrowerThanTheSampleTellsAndWiderThanPlatesAndWelds) {
  EXPECT_FALSE(upon({0.017}));
  EXPECT_TRUE(upon({0.025}));
  EXPECT_TRUE(upon({0.1}));
  EXPECT_FALSE(upon({0.12}));
}

TEST(NarrowRingwall, ItsFaceIsThreeLayersHigh) {
  EXPECT_FALSE(upon({0.05, 0.045}));
  EXPECT_TRUE(upon({0.05, 0.09}));
}

TEST(NarrowRingwall, ItsFaceIsStraight) {
  EXPECT_TRUE(upon({0.05, 0.15, 0.003}));
  EXPECT_FALSE(upon({0.05, 0.15, 0.0065}));
  const auto bulging = [](double by) {  // an arc of a circle, through the face's ends
    return upon({0.1, 0.1, 0.0, 0.0, 0.0, [by](double z) { return by * square((z + 0.05) / 0.05); }}).has_value();
  };
  EXPECT_TRUE(bulging(0.005));
  EXPECT_FALSE(bulging(0.012));
  const auto pipe = [](double z) { return 0.05 - std::sqrt(std::max(0.0, square(0.05) - square(z + 0.05))); };
  EXPECT_FALSE(upon({0.1, 0.1, 0.0, 0.0, 0.0, pipe}));  // along the foot
}

TEST(NarrowRingwall, StandsUnderMostOfTheShell) {
  EXPECT_TRUE(upon({0.05, 0.15, 0.0, 0.45}));
  EXPECT_FALSE(upon({0.05, 0.15, 0.0, 0.55}));
}

TEST(NarrowRingwall, IsSeenUnderAQuarterOfTheShell) {
  EXPECT_TRUE(upon({0.05, 0.15, 0.0, 0.0, 0.7}));
  EXPECT_FALSE(upon({0.05, 0.15, 0.0, 0.0, 0.8}));
}

TEST(NarrowRingwall, IsLookedForFromOutsideAlone) {
  Tank tank = foundTank({});
  tank.side = Side::Inside;
  EXPECT_FALSE(onNarrowRingwall(ringOf({}), {}, tank));
}

TEST(NarrowRingwall, OfThingsInOtherUnitsIsInProportion) {
  const Scene scene;
  Ring ring = ringOf(scene);
  for (Eigen::Vector3d& p : ring.points) p *= 1000.0;
  ring.reach *= 1000.0;
  Tank tank = foundTank(scene);
  tank.circle.radius *= 1000.0, tank.resolution *= 1000.0, tank.foot.coefficients *= 1000.0;
  const std::optional<Tank> found = onNarrowRingwall(ring, {}, tank);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->ringwall_width, 50.0, 2.0);
  EXPECT_NEAR(found->foot(1.0), 0.0, 6.0);
}

}  // namespace tank_datum::narrow_ringwall_test
