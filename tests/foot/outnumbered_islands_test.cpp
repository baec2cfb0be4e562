#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "foot/foot_check.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFar = 10;

/// Stations 0 to 99 stand. From `first` on so many more stand, each beside another that lies on something else, then
/// only the latter.
std::vector<Unmeasured> ringWith(std::size_t first, std::size_t stand, std::size_t other) {
  std::vector<Unmeasured> reasons(360, Unmeasured::Hidden);
  std::fill_n(reasons.begin(), 100, Unmeasured::None);
  for (std::size_t k = 0; k < stand + other; ++k) {
    const bool stands = k % 2 == 0 ? k / 2 < stand : k / 2 >= other;
    reasons[first + k] = stands ? Unmeasured::None : Unmeasured::OtherSurface;
  }
  return reasons;
}

bool isOutnumbered(const std::vector<Unmeasured>& reasons, std::size_t station) {
  return findOutnumberedIslands(reasons, kFar)[station];
}

TEST(FindOutnumberedIslands, AnIslandOfMoreThatLieOnSomethingElseCountsAsThat) {
  const std::vector<Unmeasured> reasons = ringWith(200, 9, 10);
  ASSERT_EQ(std::count(reasons.begin(), reasons.end(), Unmeasured::OtherSurface), 10);
  EXPECT_TRUE(isOutnumbered(reasons, 200));
  EXPECT_FALSE(isOutnumbered(reasons, 0));
}

TEST(FindOutnumberedIslands, OneOfAsManyStands) { EXPECT_FALSE(isOutnumbered(ringWith(200, 10, 10), 200)); }

TEST(FindOutnumberedIslands, WhatIsNearTheOthersIsNoIsland) {
  EXPECT_FALSE(isOutnumbered(ringWith(110, 9, 10), 110));
  EXPECT_TRUE(isOutnumbered(ringWith(111, 9, 10), 111));
}

TEST(FindOutnumberedIslands, WhereMostStandTheyStay) {
  std::vector<Unmeasured> reasons = ringWith(200, 0, 0);
  for (std::size_t i = 0; i < 100; i += 3) reasons[i] = reasons[i + 1] = Unmeasured::OtherSurface;
  EXPECT_FALSE(isOutnumbered(reasons, 2));
}

}  // namespace
}  // namespace tank_datum
