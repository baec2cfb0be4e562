#include "setups/repeated_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tank_datum::repeated_points_test {

Points madePoints(std::size_t count, double step, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p(place(random), place(random), 0.01 * place(random));
    if (step > 0.0) p = (p / step).array().round() * step;
    points.push_back(p);
  }
  return points;
}

Ring ringOf(const std::vector<Points>& setups) {
  Ring ring;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    ring.setups.push_back({static_cast<std::uint32_t>(s), 0});
    for (const auto& p : setups[s]) {
      ring.points.push_back(p);
      ring.point_setups.push_back(static_cast<std::uint16_t>(s));
    }
  }
  if (setups.size() == 1) ring.point_setups.clear();
  return ring;
}

TEST(RepeatedPoints, AFileGivenTwiceIsUsedOnce) {
  for (const std::size_t count : {std::size_t{5'000}, std::size_t{100'000}}) {
    const Points a = madePoints(count, 0.0, 1), b = madePoints(count, 0.0, 2);
    Ring ring = ringOf({a, b, a});
    const RepeatedPoints repeated = removeRepeated(ring);
    EXPECT_EQ(repeated.removed, count);
    EXPECT_EQ(ring.points.size(), 2 * count);
    EXPECT_EQ(ring.point_setups.size(), 2 * count);
    EXPECT_EQ(repeated.of_setups, (std::vector<double>{0.0, 0.0, 1.0}));
    EXPECT_EQ(ring.points.front(), a.front());
    EXPECT_EQ(ring.points.back(), b.back());
  }
}

TEST(RepeatedPoints, ACloudThatHoldsEachPointTenTimesIsUsedOnce) {
  const Points a = madePoints(4'000, 0.0, 3);
  Points ten;
  for (int i = 0; i < 10; ++i) ten.insert(ten.end(), a.begin(), a.end());
  Ring ring = ringOf({ten});
  EXPECT_EQ(removeRepeated(ring).removed, 9 * a.size());
  EXPECT_EQ(ring.points, a);
}

TEST(RepeatedPoints, CoordinatesOfFewDigitsThatMeetByChanceStay) {
  Ring ring = ringOf({madePoints(20'000, 0.05, 4), madePoints(20'000, 0.05, 5)});
  EXPECT_EQ(removeRepeated(ring).removed, 0U);
  EXPECT_EQ(ring.points.size(), 40'000U);
}

TEST(RepeatedPoints, PointsThatAThirdOfASetupSharesAreNoChance) {
  for (const std::size_t shared : {1'250U, 1'750U}) {  // of five thousand
    const Points a = madePoints(5'000, 0.0, 6);
    Points b = madePoints(5'000, 0.0, 7);
    std::copy(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shared), b.begin());
    Ring ring = ringOf({a, b});
    EXPECT_EQ(removeRepeated(ring).removed, shared > 1'500U ? shared : 0U);
  }
}

}  // namespace tank_datum::repeated_points_test
