#include "foot/raised_foot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "support/made_feet.h"

namespace tank_datum::raised_foot_test {

using made_feet::kScales;
using made_feet::MadeFoot;

constexpr double kScatter = 0.004;  // of where the shell is seen lowest [m]

/// A foot of which the first stations stand on a level, the shell of the others being seen from another on.
struct Scene {
  int standing = 60;
  std::function<double(double)> stands = [](double) { return 0.0; };  ///< of a direction
  std::function<double(double)> seen = [](double) { return 0.0; };
  int points = 20;      ///< of the shell at a station
  int strays = 0;       ///< 50 mm lower
  double before = 0.0;  ///< the shell's points [m]
  int seen_to = 360;    ///< station from which on nothing is seen
  double scatter = kScatter;
};

double raised(const Scene& scene) {
  MadeFoot made;
  std::vector<FootFit> fits(360);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0.0, scene.scatter);
  for (int s = 0; s < 360; ++s) {
    if (s < scene.standing) {
      fits[static_cast<std::size_t>(s)].z = scene.stands(s * made.step());
      fits[static_cast<std::size_t>(s)].sigma = 0.0003;
    } else if (s < scene.seen_to) {
      const double lowest = scene.seen(s * made.step()) + normal(random);
      for (int i = 0; i < scene.points - scene.strays; ++i)
        made.add(s * made.step(), scene.before, lowest + 0.0001 * i);
      for (int i = 0; i < scene.strays; ++i) made.add(s * made.step(), scene.before, lowest - 0.05);
    }
  }
  return raisedAboveRest(made.foot(), fits);
}

Scene heaped(double height) {
  Scene scene;
  scene.stands = [height](double) { return height; };
  return scene;
}

TEST(RaisedAboveRest, IsTheHeightOverWhatTheLowestOfTheShellScattersBy) {
  const double scatter = std::hypot(kScatter, kScales.shell_noise);
  EXPECT_NEAR(raised(heaped(0.04)), 0.04 / scatter, 0.15 * 0.04 / scatter);
  EXPECT_NEAR(raised(heaped(-0.04)), -0.04 / scatter, 0.15 * 0.04 / scatter);
}

TEST(RaisedAboveRest, OfAShellThatIsSeenEverywhereAlikeIsWhatItsNoiseMakes) {
  Scene scene = heaped(0.01);
  scene.scatter = 1e-6;
  EXPECT_NEAR(raised(scene), 0.01 / kScales.shell_noise, 0.3);
}

TEST(RaisedAboveRest, ATiltAndAWaveOfTheDatumAreNone) {
  Scene scene;
  scene.stands = [](double at) { return 0.1 * std::cos(at) + 0.015 * std::cos(2.0 * at); };
  scene.seen = [](double at) { return 0.1 * std::cos(at) + 0.015 * std::cos(2.0 * at); };
  EXPECT_LT(raised(scene), 2.5);
}

TEST(RaisedAboveRest, StraysBelowAShellAreNotSeenOfItFromTwoDownAndThingsBeforeASixthOfItDoNotCount) {
  Scene scene = heaped(0.04);
  scene.strays = 2;
  EXPECT_NEAR(raised(scene), raised(heaped(0.04)), 0.1);
  scene.strays = 3;
  EXPECT_GT(raised(scene), 1.5 * raised(heaped(0.04)));
  Scene grown = heaped(0.04);
  grown.seen = [](double at) { return at > 5.5 ? 0.2 : 0.0; };
  EXPECT_GT(raised(grown), 4.0);
}

TEST(RaisedAboveRest, IsNotKnownWhereLessIsSeenThanStands) {
  Scene scene = heaped(0.04);
  scene.seen_to = 119;
  EXPECT_TRUE(std::isnan(raised(scene)));
  scene.seen_to = 121;
  EXPECT_GT(raised(scene), 5.0);
  scene.standing = 0;
  EXPECT_TRUE(std::isnan(raised(scene)));
}

TEST(RaisedAboveRest, TenPointsOfTheShellTellWhereItIsSeen) {
  Scene scene = heaped(0.04);
  scene.points = 9;
  EXPECT_TRUE(std::isnan(raised(scene)));
  scene.points = 10;
  EXPECT_GT(raised(scene), 5.0);
  scene.before = 1.9 * kScales.shell_noise;
  EXPECT_GT(raised(scene), 5.0);
  scene.before = 2.1 * kScales.shell_noise;
  EXPECT_TRUE(std::isnan(raised(scene)));
}

}  // namespace tank_datum::raised_foot_test
