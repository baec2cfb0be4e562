#include "core/least_without.h"

#include <gtest/gtest.h>

namespace tank_datum::least_without_test {

TEST(LeastWithout, IsWhereAFallingExcessEnds) {
  const auto excess = [](double x) { return 0.3 - x; };
  EXPECT_NEAR(leastWithout(excess, 1.0, 20), 0.3, 1e-6);
  EXPECT_NEAR(leastWithout(excess, 1.0, 2), 0.5, 1e-12);
}

TEST(LeastWithout, IsZeroWithoutAnExcessAndTheMostWhereItStays) {
  EXPECT_EQ(leastWithout([](double) { return 0.0; }, 1.0, 20), 0.0);
  EXPECT_EQ(leastWithout([](double) { return 1.0; }, 0.5, 20), 0.5);
}

}  // namespace tank_datum::least_without_test
