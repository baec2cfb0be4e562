#include "foot/station_stretches.h"

#include <gtest/gtest.h>

namespace tank_datum::station_stretches_test {

constexpr std::size_t kLongest = 5;

std::vector<StationStretch> stretches(const std::vector<std::size_t>& counts, std::vector<bool> fitted = {}) {
  fitted.resize(counts.size(), true);
  return stretchesOf(counts, fitted, kLongest);
}

TEST(StretchesOf, StationsWithPointsEnoughStandAlone) {
  const auto found = stretches({8, 0, 9});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].first, 2U);
  EXPECT_EQ(found[1].count, 1U);
  EXPECT_EQ(found[1].at, 2U);
  EXPECT_DOUBLE_EQ(found[1].besideMiddle(), 0.0);
}

TEST(StretchesOf, NoneBeginsOrEndsWithoutPoints) {
  const auto found = stretches({0, 3, 0, 2, 0, 0, 0});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, 1U);
  EXPECT_EQ(found[0].count, 3U);
}

TEST(StretchesOf, AStretchIsFittedWhereMostOfItsPointsAre) {
  const auto found = stretches({1, 2, 0, 1, 14});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at, 3U);  // the middle of the points is at 3.4, between few points and many
  EXPECT_DOUBLE_EQ(found[0].besideMiddle(), 1.0);
  const auto pair = stretches({7, 3});
  EXPECT_EQ(pair[0].at, 0U);
  EXPECT_DOUBLE_EQ(pair[0].besideMiddle(), -0.5);
}

TEST(StretchesOf, AStretchWhoseMiddleIsHiddenIsFittedBesideIt) {
  EXPECT_EQ(stretches({1, 2, 0, 1, 1})[0].at, 1U) << "has no points";
  EXPECT_EQ(stretches({1, 2, 3, 1, 1}, {true, false, false, true, true})[0].at, 3U) << "has no fit";
}

}  // namespace tank_datum::station_stretches_test
