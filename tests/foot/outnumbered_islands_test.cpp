#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "foot/foot_check.h"

namespace tank_datum::outnumbered_islands_test {

constexpr std::size_t kFar = 10;

/// Stations 0 to 99 stand, and so many from 200 on; `other` lie on something else from `from` on.
std::vector<Unmeasured> ringWith(std::size_t stand, std::size_t from, std::size_t other) {
  std::vector<Unmeasured> reasons(360, Unmeasured::Hidden);
  std::fill_n(reasons.begin(), 100, Unmeasured::None);
  std::fill_n(reasons.begin() + 200, stand, Unmeasured::None);
  std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(from), other, Unmeasured::OtherSurface);
  return reasons;
}

bool isOutnumbered(const std::vector<Unmeasured>& reasons, std::size_t station) {
  return findOutnumberedIslands(reasons, kFar)[station];
}

TEST(FindOutnumberedIslands, AnIslandWithMoreOfSomethingElseAmongItsStationsIsThat) {
  const std::vector<Unmeasured> reasons = ringWith(19, 205, 10);
  EXPECT_TRUE(isOutnumbered(reasons, 200));
  EXPECT_TRUE(isOutnumbered(reasons, 218));
  EXPECT_FALSE(isOutnumbered(reasons, 205));  // is that already
  EXPECT_FALSE(isOutnumbered(reasons, 0));
  EXPECT_FALSE(isOutnumbered(ringWith(20, 205, 10), 200));  // as many
}

TEST(FindOutnumberedIslands, WhatLiesBesideCountsAsFarAsTheIslandReaches) {
  std::vector<Unmeasured> reasons = ringWith(8, 208, 8);
  EXPECT_FALSE(isOutnumbered(reasons, 200));
  reasons[216] = Unmeasured::OtherSurface;  // one too far
  EXPECT_FALSE(isOutnumbered(reasons, 200));
  reasons[192] = Unmeasured::OtherSurface;
  EXPECT_TRUE(isOutnumbered(reasons, 200));
}

TEST(FindOutnumberedIslands, WhatLiesFartherThanNoGapIsBridgedDoesNot) {
  std::vector<Unmeasured> reasons = ringWith(30, 240, 31);
  EXPECT_FALSE(isOutnumbered(reasons, 200));
  reasons = ringWith(9, 209, 10);
  reasons[205] = Unmeasured::OtherSurface;
  EXPECT_TRUE(isOutnumbered(reasons, 200));
}

TEST(FindOutnumberedIslands, WhatIsNearTheOthersIsNoIsland) {
  const auto near = [](std::size_t gap) {
    std::vector<Unmeasured> reasons = ringWith(0, 0, 0);
    std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(100 + gap), 4, Unmeasured::None);
    std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(104 + gap), 4, Unmeasured::OtherSurface);
    reasons[99 + gap] = Unmeasured::OtherSurface;
    return isOutnumbered(reasons, 100 + gap);
  };
  EXPECT_FALSE(near(kFar));
  EXPECT_TRUE(near(kFar + 1));
}

TEST(FindOutnumberedIslands, WhereMostStandTheyStay) {
  std::vector<Unmeasured> reasons = ringWith(0, 0, 0);
  for (std::size_t i = 0; i < 100; i += 3) reasons[i] = reasons[i + 1] = Unmeasured::OtherSurface;
  EXPECT_FALSE(isOutnumbered(reasons, 2));
}

/// Stations 0 to 99 stand, and so many on their own from `from` on.
bool areLone(std::size_t from, std::size_t stand) {
  std::vector<Unmeasured> reasons = ringWith(0, 0, 0);
  std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(from), stand, Unmeasured::None);
  const std::vector<bool> lone = findLoneStations(reasons, kFar);
  EXPECT_FALSE(lone[99]);
  EXPECT_EQ(std::count(lone.begin(), lone.end(), true), lone[from] ? static_cast<std::ptrdiff_t>(stand) : 0);
  return lone[from];
}

TEST(FindLoneStations, AFewBetweenGapsThatAreNotBridgedAreAlone) {
  EXPECT_TRUE(areLone(200, 1));
  EXPECT_TRUE(areLone(200, 2));
  EXPECT_FALSE(areLone(200, 3));
  EXPECT_TRUE(areLone(100 + kFar + 1, 1));
  EXPECT_FALSE(areLone(100 + kFar, 1));
}

TEST(FindLoneStations, TheLongestIslandIsNot) {
  std::vector<Unmeasured> reasons(360, Unmeasured::Hidden);
  reasons[359] = reasons[0] = Unmeasured::None;  // one island over the end of the ring
  reasons[100] = Unmeasured::None;
  const std::vector<bool> lone = findLoneStations(reasons, kFar);
  EXPECT_TRUE(lone[100]);
  EXPECT_FALSE(lone[0]);
}

}  // namespace tank_datum::outnumbered_islands_test
