#include "setups/turned_grid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/units.h"

namespace tank_datum::turned_grid_test {

constexpr double kFinest = 2e-4;

/// A wall with noise, rounded to a step and turned.
Points wall(double step, double turn, int count = 20'000) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any;
  std::normal_distribution<double> noise(0.0, 0.001);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double azimuth = kTwoPi * any(random), radius = 8.0 + noise(random);
    Eigen::Vector3d p(radius * std::cos(azimuth), radius * std::sin(azimuth), any(random));
    if (step > 0.0) p.head<2>() = (p.head<2>() / step).array().round() * step;
    points.push_back(Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * p);
  }
  return points;
}

/// Two places a step apart, and some others by themselves, so many points of each.
struct Places {
  Points points;
  int count = 0;

  Places& add(double length, double direction, int pairs, int of_each = 2) {
    for (int k = 0; k < pairs; ++k, ++count) {
      const Eigen::Vector3d first(10.0 * count, 0.1 * count, 0.0);
      const Eigen::Vector3d step(std::cos(direction), std::sin(direction), 0.0);
      for (int i = 0; i < of_each; ++i) points.push_back(first), points.push_back(first + length * step);
    }
    return *this;
  }
  Places& alone(int places) {
    for (int k = 0; k < places; ++k, ++count) points.insert(points.end(), 2, {10.0 * count, 0.1 * count, 0.0});
    return *this;
  }
  double step() const { return turnedGridStep(points, kFinest); }
};

TEST(TurnedGrid, IsSeenWhicheverWayItWasTurned) {
  for (const double turn : {0.0, 5.0 * kDegree, 35.0 * kDegree, 45.0 * kDegree, 200.0 * kDegree}) {
    EXPECT_NEAR(turnedGridStep(wall(0.010, turn), kFinest), 0.010, 1e-9) << turn;
    EXPECT_NEAR(turnedGridStep(wall(0.004, turn), kFinest), 0.004, 1e-9) << turn;
  }
  EXPECT_EQ(turnedGridStep(wall(0.0, 0.0), kFinest), 0.0);
  EXPECT_EQ(turnedGridStep({}, kFinest), 0.0);
}

TEST(TurnedGrid, IsNoWallDrawnInColumns) {
  Points points;
  for (int column = 0; column < 2000; ++column) {
    const double azimuth = kTwoPi * column / 2000;
    for (int i = 0; i < 10; ++i) points.push_back({8.0 * std::cos(azimuth), 8.0 * std::sin(azimuth), 0.01 * i});
  }
  EXPECT_EQ(turnedGridStep(points, kFinest), 0.0);
}

TEST(TurnedGrid, APointInTwentySharesItsPlace) {
  EXPECT_EQ(Places().add(0.005, 0.3, 96, 1).add(0.005, 0.3, 4).step(), 0.0);  // 4 %
  EXPECT_NEAR(Places().add(0.005, 0.3, 92, 1).add(0.005, 0.3, 8).step(), 0.005, 1e-9);
}

TEST(TurnedGrid, ATenthOfThePlacesHaveANeighbour) {
  EXPECT_NEAR(Places().add(0.005, 0.3, 13).alone(74).step(), 0.005, 1e-9);
  EXPECT_NE(Places().add(0.005, 0.3, 7).alone(86).step(), 0.005);
  EXPECT_GT(Places().add(0.005, 0.3, 7).alone(86).step(), 1.0);
}

TEST(TurnedGrid, ItsStepsLieAlongOrAcrossOneDirection) {
  EXPECT_NEAR(Places().add(0.005, 0.3, 50).add(0.005, 0.3 - 90.0 * kDegree, 50).step(), 0.005, 1e-9);
  EXPECT_EQ(Places().add(0.005, 0.3, 70).add(0.005, 0.3 + 45.0 * kDegree, 30).step(), 0.0);
  EXPECT_EQ(Places().add(0.005, 0.3, 90).add(0.005, 0.3 + 45.0 * kDegree, 10).step(), 0.0);
  EXPECT_NEAR(Places().add(0.005, 0.3, 99).add(0.005, 0.3 + 45.0 * kDegree, 1).step(), 0.005, 1e-9);
}

TEST(TurnedGrid, StepsAreAlikeToAFiftieth) {
  EXPECT_NEAR(Places().add(0.005, 0.3, 50).add(0.00515, 0.3 + 45.0 * kDegree, 50).step(), 0.005, 1e-9);
  EXPECT_EQ(Places().add(0.005, 0.3, 50).add(0.00507, 0.3 + 45.0 * kDegree, 50).step(), 0.0);
}

TEST(TurnedGrid, FinerStepsAreNone) { EXPECT_EQ(Places().add(0.00019, 0.3, 50).step(), 0.0); }

}  // namespace tank_datum::turned_grid_test
