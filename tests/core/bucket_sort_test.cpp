#include "core/bucket_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace tank_datum::bucket_sort_test {

using Values = std::vector<unsigned, DefaultInitAllocator<unsigned>>;

Values randomValues(std::size_t count, unsigned most) {
  std::mt19937 random(1);
  Values values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<unsigned>(random() % most));
  return values;
}

TEST(SortByBuckets, IsASortForAnyNumberOfValuesBucketsAndThreads) {
  for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 50'000U}) {
    for (const unsigned bucket_width : {1U, 10U, 1000U}) {
      for (const int threads : {1, 2, 0}) {
        Values values = randomValues(count, 1000), expected = values;
        std::sort(expected.begin(), expected.end());
        sortByBuckets(
            values, 1000, [bucket_width](unsigned value) { return std::size_t{value / bucket_width}; },
            std::less<unsigned>(), threads);
        EXPECT_EQ(values, expected) << count << " " << bucket_width;
      }
    }
  }
}

}  // namespace tank_datum::bucket_sort_test
