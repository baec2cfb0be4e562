#include "setups/rounded_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace tank_datum::rounded_points_test {

/// Points at random places of a foot, rounded to a step; 0: not.
Points pointsRoundedTo(double step, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  Points points;
  for (int i = 0; i < 30'000; ++i) {
    Eigen::Vector3d p(place(random), place(random), 0.05 * place(random));
    if (step > 0.0) p = (p / step).array().round() * step;
    points.push_back(p);
  }
  return points;
}

TEST(RoundedPoints, AreSpreadEvenlyOverTheirSteps) {
  Ring ring;
  const Points given = ring.points = pointsRoundedTo(0.001, 1);
  spreadRounded(ring, 1.0);
  EXPECT_NEAR(ring.rounding, 0.001, 1e-9);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    double sum = 0.0, squares = 0.0, most = 0.0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const double moved = ring.points[i][axis] - given[i][axis];
      sum += moved, squares += moved * moved, most = std::max(most, std::abs(moved));
    }
    const auto count = static_cast<double>(given.size());
    EXPECT_NEAR(sum / count, 0.0, 1e-5);
    EXPECT_NEAR(std::sqrt(squares / count), 0.001 / std::sqrt(12.0), 1e-5);
    EXPECT_LE(most, 0.0005 + 1e-9);
  }
}

TEST(RoundedPoints, InAnotherOrderAreSpreadAlike) {
  Ring ring, turned;
  ring.points = turned.points = pointsRoundedTo(0.002, 2);
  std::reverse(turned.points.begin(), turned.points.end());
  spreadRounded(ring, 1.0), spreadRounded(turned, 1.0);
  std::reverse(turned.points.begin(), turned.points.end());
  EXPECT_EQ(ring.points, turned.points);
}

TEST(RoundedPoints, StepsOfAFifthOfAMillimetreAndMoreCount) {
  const auto rounding = [](double step, double unit) {
    Ring ring;
    const Points given = ring.points = pointsRoundedTo(step, 3);
    spreadRounded(ring, unit);
    EXPECT_EQ(ring.points == given, ring.rounding == 0.0);
    return ring.rounding;
  };
  EXPECT_EQ(rounding(0.0, 1.0), 0.0);
  EXPECT_EQ(rounding(0.00015, 1.0), 0.0);
  EXPECT_NEAR(rounding(0.00025, 1.0), 0.00025, 1e-9);
  EXPECT_EQ(rounding(0.00025, 10.0), 0.0) << "of a tank in other units";
}

TEST(RoundedPoints, OfThirtySetupsEachTells) {
  Ring ring;
  for (std::uint16_t s = 0; s < 30; ++s) {
    ring.setups.push_back({s, 0});
    for (const auto& p : pointsRoundedTo(0.001, 10 + s)) ring.points.push_back(p), ring.point_setups.push_back(s);
  }
  const Points given = ring.points;
  spreadRounded(ring, 1.0);
  for (std::size_t i = 0; i < given.size(); i += 30'000) EXPECT_NE(ring.points[i].z(), given[i].z()) << i;
}

TEST(RoundedPoints, WhatWasTurnedSinceIsRoundedUnseen) {
  Ring ring;
  ring.points = pointsRoundedTo(0.001, 6);
  for (auto& p : ring.points) p = Eigen::AngleAxisd(0.001, Eigen::Vector3d::UnitX()) * p;
  const double given = ring.points[0].z();
  spreadRounded(ring, 1.0);
  EXPECT_NEAR(ring.rounding, 0.001, 1e-9);
  EXPECT_NE(ring.points[0].z(), given);
}

TEST(RoundedPoints, WhatWasTurnedAboutZIsSpreadInPlan) {
  Ring ring;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> any;
  for (int i = 0; i < 20'000; ++i) {
    const double azimuth = 6.28 * any(random);
    const Eigen::Vector3d p(0.005 * std::round(1600.0 * std::cos(azimuth)),
                            0.005 * std::round(1600.0 * std::sin(azimuth)), any(random));
    ring.points.push_back(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()) * p);
  }
  const Points given = ring.points;
  spreadRounded(ring, 1.0);
  EXPECT_EQ(ring.rounding, 0.0) << "elevations are not rounded";
  EXPECT_EQ(ring.points[0].z(), given[0].z());
  double most = 0.0;
  for (std::size_t i = 0; i < given.size(); ++i)
    most = std::max(most, (ring.points[i] - given[i]).cwiseAbs().maxCoeff());
  EXPECT_NEAR(most, 0.0025, 1e-5);
}

TEST(RoundedPoints, OfFloatsEachAxisHasItsOwnStep) {
  const auto rounding_of_z = [](double step) {
    Ring ring;
    ring.points = pointsRoundedTo(step, 7);
    const Points fine = pointsRoundedTo(0.0, 7);
    for (std::size_t i = 0; i < fine.size(); ++i) ring.points[i].z() = fine[i].z();
    const double given = ring.points[0].x();
    spreadRounded(ring, 1.0);
    EXPECT_NE(ring.points[0].x(), given);
    return ring.rounding;
  };
  EXPECT_EQ(rounding_of_z(0x1p-7), 0.0);
  EXPECT_NEAR(rounding_of_z(0.002), 0.002, 1e-9) << "a decimal step, 2.3 % from a power of two";
  EXPECT_NEAR(rounding_of_z(0.008), 0.008, 1e-9);
}

TEST(RoundedPoints, OneSetupMayBeRoundedAndAnotherNot) {
  Ring ring;
  const Points rounded = pointsRoundedTo(0.001, 4), whole = pointsRoundedTo(0.0, 5);
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    ring.points.push_back(rounded[i]), ring.point_setups.push_back(0);
    ring.points.push_back(whole[i]), ring.point_setups.push_back(1);
  }
  ring.setups = {{0, 0}, {1, 0}};
  spreadRounded(ring, 1.0);
  EXPECT_NEAR(ring.rounding, 0.001, 1e-9);
  EXPECT_NE(ring.points[0], rounded[0]);
  EXPECT_EQ(ring.points[1], whole[0]);
}

}  // namespace tank_datum::rounded_points_test
