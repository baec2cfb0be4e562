#include "core/parts.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace tank_datum::parts_test {

std::vector<std::size_t> indices(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> all(end - begin);
  std::iota(all.begin(), all.end(), begin);
  return all;
}

TEST(OfParts, AreOfAllIndicesInTheirOrder) {
  for (const std::size_t count : {0U, 1U, 5U, 16U, 1000U}) {
    for (const int threads : {1, 2}) EXPECT_EQ(concatenated(ofParts(count, threads, indices)), indices(0, count));
  }
}

TEST(OfParts, AreTheSameForAnyNumberOfThreads) { EXPECT_EQ(ofParts(99, 1, indices), ofParts(99, 2, indices)); }

TEST(OfParts, AreSeveral) {
  const auto parts = ofParts(1000, 2, indices);
  EXPECT_GE(parts.size(), 8U);
  for (const auto& part : parts) EXPECT_LE(part.size(), 1000U / 8U);
}

TEST(OfParts, ThrowWhatTheWorkThrows) {
  const auto fail = [](std::size_t, std::size_t) -> int { throw std::runtime_error("full"); };
  EXPECT_THROW(ofParts(10, 2, fail), std::runtime_error);
}

TEST(RangeOf, IsOfTheLeastAndTheLargest) {
  const std::vector<int> values{3, -7, 5, 0, 12, 1};
  const auto range = rangeOf(values.size(), 2, [&](std::size_t i) { return values[i]; });
  EXPECT_EQ(range.first, -7);
  EXPECT_EQ(range.second, 12);
}

TEST(RangeOf, OfOneValueIsIt) {
  const auto range = rangeOf(1, 2, [](std::size_t) { return 4.5; });
  EXPECT_EQ(range.first, 4.5);
  EXPECT_EQ(range.second, 4.5);
}

TEST(CountWhere, IsOfAllThatPass) {
  const auto is_third = [](std::size_t i) { return i % 3 == 0; };
  for (const int threads : {1, 2}) {
    EXPECT_EQ(countWhere(1000, threads, is_third), 334U);
    EXPECT_EQ(countWhere(0, threads, is_third), 0U);
  }
}

}  // namespace tank_datum::parts_test
