#include "setups/double_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/units.h"
#include "stations/stations.h"

namespace tank_datum::double_surface_test {

constexpr double kRadius = 10.0, kReach = 0.5, kNoise = 0.0005;
const FoundationBand kBand{0.02, 0.25, 0.0, kNoise};

/// Points of the foundation in arcs of five degrees.
struct MadeArcs {
  int arcs = 6;
  int every = 1;                                      ///< how many arcs further the next one is
  int points = 400;                                   ///< an arc
  double share = 0.5;                                 ///< of the second scan
  double apart = 0.004;                               ///< of the two scans
  std::function<bool(double t, double d)> is_second;  ///< t, d in [0, 1]; else by chance
  double noise = kNoise;
  std::function<double()> above = [] { return 0.0; };  ///< the surface, of each point

  double disagreement(Side side = Side::Outside) const {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, noise);
    std::uniform_real_distribution<double> any;
    Ring ring;
    ring.reach = kReach;
    for (int i = 0; i < arcs * points; ++i) {
      const double t = any(random), across = any(random), chance = any(random);
      const double azimuth = toRadians(5.0 * (i / points * every + t)),
                   d = kBand.from + (kBand.to - kBand.from) * across;
      const double r = side == Side::Outside ? kRadius + d : kRadius - d;
      const bool second = is_second ? is_second(t, across) : chance < share;
      ring.points.push_back(
          {r * std::cos(azimuth), r * std::sin(azimuth), (second ? apart : 0.0) + normal(random) + above()});
    }
    std::vector<Station> stations = emptyStations({});
    for (Station& s : stations) s.z = 0.5 * apart, s.radius = kRadius;
    Tank tank;
    tank.side = side;
    return doubleDisagreement(ring, tank, stations, {0.0, 0.0}, kBand);
  }
};

TEST(DoubleSurface, TwoScansShowByTheirDistance) {
  for (const Side side : {Side::Outside, Side::Inside}) {
    EXPECT_NEAR(MadeArcs{}.disagreement(side), 0.004 / std::sqrt(2.0), 0.0001);
  }
}

TEST(DoubleSurface, OneScanShowsNothing) {
  MadeArcs one;
  one.arcs = 72, one.share = 0.0;
  EXPECT_EQ(one.disagreement(), 0.0);
}

TEST(DoubleSurface, AStepOfTheFoundationIsNoSecondScan) {
  MadeArcs step;
  step.is_second = [](double t, double) { return t < 0.4; };  // at the joint of two plates
  EXPECT_EQ(step.disagreement(), 0.0);
  step.is_second = [](double, double d) { return d < 0.4; };  // at a plate's edge
  EXPECT_EQ(step.disagreement(), 0.0);
}

TEST(DoubleSurface, ASecondScanMayCoverAPartOfAnArc) {
  MadeArcs made;
  std::mt19937_64 random(2);
  std::bernoulli_distribution half;
  made.is_second = [&](double t, double) { return t < 0.4 && half(random); };
  EXPECT_GT(made.disagreement(), 0.002);
}

/// Levels by patches of an arc, so many along it and a quarter as many across, at random.
double ofPatches(int along) {
  MadeArcs made;
  std::mt19937_64 random(2);
  std::bernoulli_distribution half;
  std::vector<bool> second;
  for (int i = 0; i < along * along; ++i) second.push_back(half(random));
  made.is_second = [&](double t, double d) {
    const auto column = static_cast<std::size_t>(t * along), row = static_cast<std::size_t>(d * along / 4);
    return second[column * static_cast<std::size_t>(along) + row];
  };
  return made.disagreement();
}

TEST(DoubleSurface, RoughnessOfOneSurfaceIsNoSecondScanRowsOfAScanAre) {
  EXPECT_EQ(ofPatches(8), 0.0) << "25 points lie together";
  EXPECT_GT(ofPatches(28), 0.002) << "two lie together";
}

TEST(DoubleSurface, LevelsMustBeThreeDeviationsApart) {
  MadeArcs made;
  made.points = 900;
  made.apart = 2.4 * kNoise;
  EXPECT_EQ(made.disagreement(), 0.0);
  made.apart = 3.6 * kNoise;
  EXPECT_GT(made.disagreement(), kNoise);
}

TEST(DoubleSurface, TwoLevelsMustBeMuchLikelierThanOne) {
  // 4 deviations apart each point gains about 0.18 of the logarithm of the likelihood: 30 gain 5, 70 gain 12
  const auto found = [](int points) {
    MadeArcs made;
    made.apart = 4.0 * kNoise, made.points = points;
    return made.disagreement() > 0.0;
  };
  EXPECT_FALSE(found(28));
  EXPECT_TRUE(found(75));
}

TEST(DoubleSurface, TwoArcsSideBySideTellOthersDoNot) {
  MadeArcs made;
  made.arcs = 1;
  EXPECT_EQ(made.disagreement(), 0.0);
  made.arcs = 2;
  EXPECT_GT(made.disagreement(), 0.002);
  made.arcs = 36, made.every = 2;
  EXPECT_EQ(made.disagreement(), 0.0);
  made.arcs = 2, made.every = 71;  // the first and the last of the ring
  EXPECT_GT(made.disagreement(), 0.002);
}

TEST(DoubleSurface, OfEachScanATenthOfThePointsIsSeen) {
  MadeArcs made;
  made.apart = 0.006;
  made.share = 0.13;
  EXPECT_GT(made.disagreement(), 0.002);
  made.share = 0.06;
  EXPECT_EQ(made.disagreement(), 0.0) << "stray points";
}

TEST(DoubleSurface, PlantsOnTheFoundationAreNoSecondScan) {
  for (const double share : {0.1, 0.3, 0.5}) {
    MadeArcs plants;
    plants.arcs = 72, plants.apart = 0.0;
    std::mt19937_64 random(3);
    std::exponential_distribution<double> height(1.0 / 0.03);
    std::bernoulli_distribution is_plant(share);
    plants.above = [&] { return is_plant(random) ? height(random) : 0.0; };
    EXPECT_EQ(plants.disagreement(), 0.0) << share;
  }
}

TEST(DoubleSurface, FewPointsTellNothing) {
  MadeArcs made;
  made.arcs = 12;
  made.apart = 0.008, made.noise = 0.0002;
  made.points = 12;
  EXPECT_EQ(made.disagreement(), 0.0);
  made.points = 32;
  EXPECT_GT(made.disagreement(), 0.002);
}

}  // namespace tank_datum::double_surface_test
