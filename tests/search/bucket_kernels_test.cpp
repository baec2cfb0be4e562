#include "search/bucket_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <vector>

#include "support/made_clouds.h"

namespace tank_datum::bucket_kernels_test {

struct Columns {
  std::vector<float> x, y, z;
  std::vector<std::uint32_t> numbers;
  std::vector<std::int32_t> hit_squared;
  std::vector<std::uint32_t> hit_numbers;

  /// Points at these distances along x; what fills up the last lanes lies at 0.
  explicit Columns(const std::vector<float>& distances) : x(distances), numbers(distances.size()) {
    const std::size_t room = padded(x.size());
    std::iota(numbers.begin(), numbers.end(), 100U);
    x.resize(room);
    y.resize(room);
    z.resize(room);
    numbers.resize(room);
    hit_squared.resize(room);
    hit_numbers.resize(room);
    count = distances.size();
  }

  std::size_t keep(float squared_limit) {
    const float here[] = {0, 0, 0};
    return keepWithin({x.data(), y.data(), z.data(), numbers.data(), count}, here, squared_limit, hits());
  }
  std::vector<std::uint64_t> sorted(std::size_t hit_count, std::size_t k) {
    std::vector<std::uint64_t> to(k);
    sortNearest(hits(), hit_count, k, to.data());
    return to;
  }
  HitColumns hits() { return {hit_squared.data(), hit_numbers.data()}; }

  std::size_t count = 0;
};

std::uint32_t numberIn(std::uint64_t found) { return static_cast<std::uint32_t>(found); }

TEST(BucketKernels, KeepThoseWithinTheLimitItselfIncludedAndNoneOfThePadding) {
  Columns columns({3, 1, 2, 5, 4, 9, 9, 9, 9, 2, 1});
  ASSERT_EQ(columns.keep(4.0F), 4U);
  EXPECT_EQ(std::vector<std::uint32_t>(columns.hit_numbers.begin(), columns.hit_numbers.begin() + 4),
            (std::vector<std::uint32_t>{101, 102, 109, 110}));
  EXPECT_EQ(columns.keep(0.5F), 0U);
  EXPECT_EQ(columns.keep(1000.0F), 11U);
}

TEST(BucketKernels, SquaredDistancesAreOfAllThreeAxes) {
  Columns columns({1, 1, 1});
  columns.y[1] = 2;
  columns.z[2] = 3;
  ASSERT_EQ(columns.keep(100.0F), 3U);
  float squared[3];
  std::memcpy(squared, columns.hit_squared.data(), sizeof squared);
  EXPECT_EQ(squared[0], 1.0F);
  EXPECT_EQ(squared[1], 5.0F);
  EXPECT_EQ(squared[2], 10.0F);
}

TEST(BucketKernels, SortTheNearestFewAndMany) {
  for (const std::size_t count : {1U, 8U, 21U, 128U, 129U, 500U}) {
    std::mt19937_64 random(count);
    std::vector<float> distances;
    for (std::size_t i = 0; i < count; ++i) distances.push_back(static_cast<float>(made_clouds::uniform(random)));
    Columns columns(distances);
    ASSERT_EQ(columns.keep(1.0F), count);
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return distances[a] < distances[b]; });
    const std::size_t k = (count + 1) / 2;
    const auto found = columns.sorted(count, k);
    for (std::size_t i = 0; i < k; ++i) EXPECT_EQ(numberIn(found[i]), order[i] + 100) << count;
  }
}

TEST(BucketKernels, OfTheEquallyFarTheLowerNumberIsFirst) {
  Columns columns({2, 1, 2, 1, 2, 1, 0.5, 2, 2, 2});
  const auto found = columns.sorted(columns.keep(100.0F), 6);
  std::vector<std::uint32_t> numbers;
  for (const auto f : found) numbers.push_back(numberIn(f));
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{106, 101, 103, 105, 100, 102}));
}

/// The last place of the row, for which two are equally far: no place is left empty by them.
TEST(BucketKernels, OfTheEquallyFarForTheLastPlaceTheLowerNumberHasIt) {
  Columns columns({0, 1, 2, 3, 3, 5});
  std::swap(columns.numbers[3], columns.numbers[4]);
  const auto found = columns.sorted(columns.keep(100.0F), 4);
  EXPECT_EQ(numberIn(found[2]), 102U);
  EXPECT_EQ(numberIn(found[3]), 103U);
}

}  // namespace tank_datum::bucket_kernels_test
