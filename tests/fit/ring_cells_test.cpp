#include "fit/ring_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::ring_cells_test {

/// The value in the middle of a place of a ring of twelve cells of which some are known.
double at(double place, std::vector<double> first_cells) {
  first_cells.resize(12, kUnknown);
  return betweenCells(first_cells, (place + 0.5) / 12.0 * kTwoPi);
}

TEST(BetweenCells, IsStraightBetweenTheMiddlesOfTwo) {
  EXPECT_NEAR(at(1.0, {0.0, 10.0, 30.0}), 10.0, 1e-9);
  EXPECT_NEAR(at(1.25, {0.0, 10.0, 30.0}), 15.0, 1e-9);
}

TEST(BetweenCells, GoesRoundTheRing) {
  const std::vector<double> cells{0.0, 1.0, 2.0, 3.0};
  EXPECT_NEAR(betweenCells(cells, 0.0), 1.5, 1e-9);
  EXPECT_NEAR(betweenCells(cells, -0.125 * kTwoPi), 3.0, 1e-9);
  EXPECT_NEAR(betweenCells(cells, 1.125 * kTwoPi), 0.0, 1e-9);
}

TEST(BetweenCells, WhereOneIsMissingItIsTheNearestsWithinThree) {
  EXPECT_EQ(at(0.25, {7.0}), 7.0);
  EXPECT_EQ(at(3.75, {7.0, kUnknown}), 7.0);
  EXPECT_TRUE(std::isnan(at(4.25, {7.0})));
  EXPECT_EQ(at(-3.75, {7.0}), 7.0);
}

TEST(RingCell, GoesRoundTheRing) {
  EXPECT_EQ(ringCell(0.0, 36), 0U);
  EXPECT_EQ(ringCell(toRadians(9.9), 36), 0U);
  EXPECT_EQ(ringCell(toRadians(10.1), 36), 1U);
  EXPECT_EQ(ringCell(toRadians(-0.1), 36), 35U);
  EXPECT_EQ(ringCell(toRadians(370.1), 36), 1U);
  EXPECT_EQ(ringCell(-1e-300, 36), 35U);
}

TEST(MiddleOfCell, LiesInItsCell) {
  EXPECT_NEAR(middleOfCell(0, 36), toRadians(5.0), 1e-12);
  EXPECT_NEAR(middleOfCell(35, 36), toRadians(355.0), 1e-12);
  EXPECT_EQ(ringCell(middleOfCell(17, 36), 36), 17U);
}

TEST(DensestOfCell, IsOfFiveAtLeast) {
  std::vector<double> values{3.0, 1.0, 2.9, 9.0};
  EXPECT_TRUE(std::isnan(densestOfCell(values)));
  values.push_back(3.1);
  EXPECT_NEAR(densestOfCell(values), 3.0, 0.11);
  EXPECT_EQ(values.front(), 1.0);
}

}  // namespace tank_datum::ring_cells_test
