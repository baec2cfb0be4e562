#include "setups/setup_ring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::setup_ring_test {

constexpr double kRadius = 10.0, kCell = kTwoPi / 1440.0;

/// The ring of a shell that is seen by so many points in each of the cells.
SetupRing ringOf(const std::vector<std::pair<int, int>>& counts) {
  Ring ring;
  ring.reach = 0.5;
  for (const auto& [cell, count] : counts) {
    for (int i = 0; i < count; ++i) {
      const double azimuth = (cell + (i + 0.5) / count) * kCell;
      ring.points.push_back({kRadius * std::cos(azimuth), kRadius * std::sin(azimuth), 0.2 + 0.01 * i});
    }
  }
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return SetupRing(ring, tank, 1);
}

double middleOf(int cell) { return (cell + 0.5) * kCell; }

TEST(SetupRing, FivePointsTellTheShellsOutlineInAQuarterOfADegreeFourDoNot) {
  EXPECT_NEAR(ringOf({{100, 5}}).outlineAt(middleOf(100)), kRadius, 1e-9);
  EXPECT_TRUE(std::isnan(ringOf({{100, 4}}).outlineAt(middleOf(100))));
}

TEST(SetupRing, TheOutlineIsTakenFromThreeCellsAwayAndNoFurther) {
  const SetupRing ring = ringOf({{100, 8}});
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(ring.outlineAt(middleOf(100) + side * 3.4 * kCell), kRadius, 1e-9);
    EXPECT_TRUE(std::isnan(ring.outlineAt(middleOf(100) + side * 4.6 * kCell)));
  }
}

TEST(SetupRing, KeepsEveryPointInItsQuarterOfADegree) {
  const SetupRing ring = ringOf({{0, 7}, {719, 9}, {1439, 6}});
  for (const auto& [cell, count] : {std::pair<std::size_t, int>{0, 7}, {1, 0}, {719, 9}, {1439, 6}}) {
    EXPECT_EQ(ring.end(cell) - ring.begin(cell), count) << cell;
  }
}

TEST(SetupRing, ArcsAreNumberedFromTheXAxisAndATurnBegunAtNoAngleEndsInTheLast) {
  const Eigen::Vector2d center(3.0, 4.0);
  const auto arcAt = [&](double degrees) {
    const double azimuth = degrees * kTwoPi / 360.0;
    return SetupRing::arcOf({3.0 + std::cos(azimuth), 4.0 + std::sin(azimuth), 0.0}, center);
  };
  EXPECT_EQ(arcAt(1.0), 0u);
  EXPECT_EQ(arcAt(2.6), 1u);
  EXPECT_EQ(arcAt(359.0), SetupRing::kArcs - 1);
  EXPECT_EQ(SetupRing::arcOf({1.0, -1e-300, 0.0}, {0.0, 0.0}), SetupRing::kArcs - 1);
}

}  // namespace tank_datum::setup_ring_test
