#include "search/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/made_clouds.h"

namespace tank_datum::spatial_order_test {

using made_clouds::uniform;

using Order = std::vector<std::uint32_t>;

TEST(MortonOrder, GoesThroughTheCornersOfACubeXFirst) {
  const Points corners = {{1, 1, 1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
  EXPECT_EQ(mortonOrder(corners), (Order{4, 2, 3, 5, 1, 7, 6, 0}));
}

TEST(MortonOrder, NamesEveryPointOnce) {
  std::mt19937_64 random(2);
  Points points;
  for (int i = 0; i < 5000; ++i) points.emplace_back(uniform(random), uniform(random), uniform(random));
  Order order = mortonOrder(points);
  double along = 0, given = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    along += (points[order[i]] - points[order[i - 1]]).norm();
    given += (points[i] - points[i - 1]).norm();
  }
  EXPECT_LT(along, 0.2 * given);
  std::sort(order.begin(), order.end());
  Order all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST(MortonOrder, OfNothingAndOfOnePlaceIsTheGivenOne) {
  EXPECT_TRUE(mortonOrder({}).empty());
  EXPECT_EQ(mortonOrder({{1, 2, 3}, {1, 2, 3}}), (Order{0, 1}));
}

}  // namespace tank_datum::spatial_order_test
