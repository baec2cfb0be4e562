#include "trust/ground_inside.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::ground_inside_test {

constexpr double kRadius = 10.0, kNoise = 0.01, kNear = 0.12;  // 2.5 times 0.4 % of the radius, and twice the noise [m]

/// A shell seen over 80 degrees with ground all round it, and ground inside of its circle over 60 more.
struct Seen {
  double wall_from = 0.10;        ///< height above the ground [m]
  int outside = 40, inside = 40;  ///< points of the ground in a sector of 5 degrees
  double from = 0.2, to = 0.4;    ///< how far inside [m]
  double at = 90.0;               ///< where it begins [deg]
  double sigma_radius = 0.0;      ///< [m]
  Side side = Side::Outside;
};

/// A tank off the origin and what is seen about it.
struct Scene {
  Tank tank;
  ShellEvidence shell;
  Ring ring;

  Scene() {
    tank.circle = {{1.0, -2.0}, kRadius};
    tank.foot.coefficients = Eigen::Vector3d(0.25, 0.0, 0.0);
    shell.circle = tank.circle;
    shell.noise = kNoise;
    shell.sigma_radius = 0.0;
    ring.reach = 0.5;
  }
  void add(double azimuth, double off, double height) {
    const double r = kRadius + off;
    ring.points.emplace_back(1.0 + r * std::cos(azimuth), -2.0 + r * std::sin(azimuth), 0.25 + height);
  }
  double share() const { return groundInside(ring, tank, shell); }
};

double shareOf(const Seen& seen) {
  Scene scene;
  scene.tank.side = seen.side;
  scene.shell.sigma_radius = seen.sigma_radius;
  const auto add = [&](double from, double to, int of_sector, double off_from, double off_to, double height) {
    const int count = static_cast<int>(std::lround((to - from) / 5.0)) * of_sector;
    for (int i = 0; i < count; ++i) {
      const double share = (i + 0.5) / count, a = (from + (to - from) * share) * kDegree;
      scene.add(a, off_from + (off_to - off_from) * std::fmod(0.618034 * i, 1.0), height);
    }
  };
  add(0.0, 80.0, 40, -0.005, 0.005, seen.wall_from);
  add(0.0, 360.0, seen.outside, 0.2, 0.4, 0.0);
  add(seen.at, seen.at + 60.0, seen.inside, -seen.from, -seen.to, 0.0);
  return scene.share();
}

TEST(GroundInside, IsCountedBesideTheWall) {
  EXPECT_NEAR(shareOf({}), 12.0 / 16.0, 1e-12);
  Seen behind;
  behind.at = 10.0;
  EXPECT_EQ(shareOf(behind), 0.0);
}

TEST(GroundInside, StraysLieThinnerThanGroundOutside) {
  Seen seen;
  seen.inside = 10;
  EXPECT_EQ(shareOf(seen), 0.0);
  seen.inside = 14;
  EXPECT_GT(shareOf(seen), 0.7);
  seen.outside = seen.inside = 4;
  EXPECT_EQ(shareOf(seen), 0.0);
  seen.outside = seen.inside = 6;
  EXPECT_GT(shareOf(seen), 0.7);
}

TEST(GroundInside, LiesClearOfTheCircle) {
  Seen seen;
  seen.from = 0.05, seen.to = kNear - 0.01;
  EXPECT_EQ(shareOf(seen), 0.0);
  seen.from = kNear + 0.01, seen.to = kNear + 0.02;
  EXPECT_GT(shareOf(seen), 0.7);
  seen.sigma_radius = 0.005;  // six of which are 30 mm
  EXPECT_EQ(shareOf(seen), 0.0);
  seen.from = kNear + 0.04, seen.to = kNear + 0.05;
  EXPECT_GT(shareOf(seen), 0.7);
}

TEST(GroundInside, AWallStandsAboveTheGround) {
  Seen seen;
  seen.wall_from = 0.08;
  EXPECT_GT(shareOf(seen), 0.7);
  seen.wall_from = 0.07;  // a kerb
  EXPECT_TRUE(std::isnan(shareOf(seen)));
}

TEST(GroundInside, FromInsideItIsTheTanksOwn) {
  Seen seen;
  seen.side = Side::Inside;
  EXPECT_TRUE(std::isnan(shareOf(seen)));
}

/// Posts every five degrees, each `wide` degrees, before ground that goes on; between them every so manyth point is of
/// a wall.
double shareBehindPosts(double wide, int of_degree, int every = 1 << 20) {
  Scene scene;
  for (int i = 0; i < 360 * of_degree; ++i) {
    const double degrees = (i + 0.5) / of_degree, a = degrees * kDegree;
    scene.add(a, 0.3, 0.0);
    std::fmod(degrees, 5.0) < wide || i % every == every - 1 ? scene.add(a, 0.0, 0.3) : scene.add(a, -0.3, 0.0);
  }
  return scene.share();
}

TEST(GroundInside, IsSeenBetweenPosts) {
  EXPECT_NEAR(shareBehindPosts(2.0, 30), 3.0 / 2.0, 1e-12);
  EXPECT_NEAR(shareBehindPosts(4.0, 30), 1.0 / 4.0, 1e-12);
  EXPECT_EQ(shareBehindPosts(2.0, 20), 0.0) << "a wall of so few points has degrees without one";
  EXPECT_EQ(shareBehindPosts(5.0, 30), 0.0) << "a wall";
}

TEST(GroundInside, BetweenPostsIsATenthOfTheirPointsAtMost) {
  EXPECT_NEAR(shareBehindPosts(2.0, 40, 20), 3.0 / 2.0, 1e-12);
  EXPECT_EQ(shareBehindPosts(2.0, 40, 7), 0.0);
}

}  // namespace tank_datum::ground_inside_test
