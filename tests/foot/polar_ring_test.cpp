#include "foot/polar_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_clouds.h"

namespace tank_datum::polar_ring_test {

using made_clouds::kTurn;
using made_clouds::uniform;

const Eigen::Vector2d kCenter(3.0, -4.0);

Points onCircle(const std::vector<double>& azimuths, double radius = 2.0) {
  Points points;
  for (const double a : azimuths) {
    points.emplace_back(kCenter.x() + radius * std::cos(a), kCenter.y() + radius * std::sin(a), 0.1 * a);
  }
  return points;
}

Points scattered(int count) {
  std::mt19937_64 random(7);
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random);
    points.emplace_back(kCenter.x() + x - 0.5, kCenter.y() + y - 0.5, uniform(random));
  }
  return points;
}

/// Turns of the points in a window, ascending.
std::vector<double> turnsIn(const PolarRing& ring, double azimuth, double half_width) {
  std::vector<double> turns;
  ring.around(azimuth, half_width, [&](const PolarPoint&, double turn) { turns.push_back(turn); });
  std::sort(turns.begin(), turns.end());
  return turns;
}

TEST(PolarRing, SeesAPointFromTheCentre) {
  const PolarRing ring({{3.0, -2.0, 7.0}}, kCenter);
  ASSERT_EQ(ring.points().size(), 1U);
  EXPECT_DOUBLE_EQ(ring.points()[0].azimuth, kTurn / 4);
  EXPECT_DOUBLE_EQ(ring.points()[0].radius, 2.0);
  EXPECT_EQ(ring.points()[0].z, 7.0);
}

TEST(PolarRing, AzimuthsAreFromZeroToBelowATurn) {
  const Points points = {{1, 0, 0},  {1, -0.0, 0},  {1, -1e-300, 0}, {1, -1e-17, 0},
                         {-1, 0, 0}, {-1, -0.0, 0}, {0, -1, 0}};
  const PolarRing ring(points, {0, 0});
  ASSERT_EQ(ring.points().size(), points.size());
  for (const PolarPoint& p : ring.points()) {
    EXPECT_GE(p.azimuth, 0.0);
    EXPECT_LT(p.azimuth, kTurn);
  }
  EXPECT_GT(ring.points().back().azimuth, 6.28);  // a hair below +x
  EXPECT_DOUBLE_EQ(ring.points()[4].azimuth, 0.75 * kTurn);
}

TEST(PolarRing, IsInOrderOfAzimuthAndKeepsEveryPoint) {
  const Points points = scattered(5000);
  const PolarRing ring(points, kCenter);
  ASSERT_EQ(ring.points().size(), points.size());
  double sum = 0, wanted = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += ring.points()[i].z;
    wanted += points[i].z();
    if (i > 0) {
      EXPECT_LE(ring.points()[i - 1].azimuth, ring.points()[i].azimuth);
    }
  }
  EXPECT_NEAR(sum, wanted, 1e-9);
}

TEST(PolarRing, DoesNotDependOnTheOrderOfThePoints) {
  Points points = scattered(2000);
  for (int i = 0; i < 50; ++i) {  // the same azimuth many times over
    points.emplace_back(kCenter.x() + 1.0 + i % 5, kCenter.y(), i / 5);
  }
  const PolarRing one(points, kCenter);
  std::reverse(points.begin(), points.end());
  const PolarRing other(points, kCenter);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one.points()[i].azimuth, other.points()[i].azimuth);
    EXPECT_EQ(one.points()[i].z, other.points()[i].z);
    EXPECT_EQ(one.points()[i].radius, other.points()[i].radius);
  }
}

TEST(PolarRing, AWindowHoldsWhatIsWithinItsHalfWidth) {
  const PolarRing ring(onCircle({0.9, 0.96, 1.0, 1.04, 1.1}), kCenter);
  const auto turns = turnsIn(ring, 1.0, 0.05);
  ASSERT_EQ(turns.size(), 3U);
  EXPECT_NEAR(turns[0], -0.04, 1e-12);
  EXPECT_NEAR(turns[1], 0.0, 1e-12);
  EXPECT_NEAR(turns[2], 0.04, 1e-12);
  EXPECT_EQ(turnsIn(ring, 1.0, 0.2).size(), 5U);
  EXPECT_EQ(turnsIn(ring, 3.0, 0.2).size(), 0U);
}

TEST(PolarRing, WindowsGoRoundTheSeamFromBothSides) {
  const PolarRing ring(onCircle({0.01, 0.03, 3.0, kTurn - 0.03, kTurn - 0.01}), kCenter);
  const auto above = turnsIn(ring, 0.01, 0.03), below = turnsIn(ring, kTurn - 0.01, 0.03);
  ASSERT_EQ(above.size(), 3U);
  EXPECT_NEAR(above[0], -0.02, 1e-12);
  EXPECT_NEAR(above[2], 0.02, 1e-12);
  ASSERT_EQ(below.size(), 3U);
  EXPECT_NEAR(below[0], -0.02, 1e-12);
  EXPECT_NEAR(below[2], 0.02, 1e-12);
}

TEST(PolarRing, AzimuthsBeyondATurnAreTheSameWindow) {
  const PolarRing ring(onCircle({0.01, kTurn - 0.01}), kCenter);
  for (const double azimuth : {-0.01, kTurn + 0.01}) {
    const auto turns = turnsIn(ring, azimuth, 0.025);
    ASSERT_EQ(turns.size(), 2U) << azimuth;
    EXPECT_NEAR(turns[1] - turns[0], 0.02, 1e-12);
    EXPECT_NEAR(std::min(std::abs(turns[0]), std::abs(turns[1])), 0.0, 1e-12);
  }
}

TEST(PolarRing, WindowsAgreeWithLookingAtEveryPoint) {
  const Points points = scattered(3000);
  const PolarRing ring(points, kCenter);
  for (const double azimuth : {0.0, 0.05, 2.0, 4.5, 6.2}) {
    for (const double half_width : {0.01, 0.3, 3.0}) {
      std::size_t wanted = 0;
      for (const auto& p : points) {
        const double a = std::atan2(p.y() - kCenter.y(), p.x() - kCenter.x());
        wanted += std::abs(std::remainder(a - azimuth, kTurn)) <= half_width;
      }
      EXPECT_EQ(turnsIn(ring, azimuth, half_width).size(), wanted) << azimuth << " " << half_width;
    }
  }
}

TEST(PolarRing, OfNoPointsHasEmptyWindows) {
  const PolarRing ring({}, kCenter);
  EXPECT_TRUE(ring.points().empty());
  EXPECT_TRUE(turnsIn(ring, 1.0, 3.0).empty());
}

}  // namespace tank_datum::polar_ring_test
