#include "core/ring_runs.h"

#include <gtest/gtest.h>

#include <utility>

namespace tank_datum::ring_runs_test {

using Ends = std::vector<std::pair<std::size_t, std::size_t>>;

Ends endsOf(const std::vector<char>& is, std::size_t gap = 0) {
  Ends ends;
  for (const RingRun& run : runsRound(is, gap)) ends.emplace_back(run.first, run.last);
  return ends;
}

TEST(RunsRound, NeighboursAreOneRun) {
  EXPECT_EQ(endsOf({0, 1, 1, 0, 1, 0}), (Ends{{1, 2}, {4, 4}}));
  EXPECT_TRUE(endsOf({0, 0, 0}).empty());
  EXPECT_TRUE(endsOf({}).empty());
}

TEST(RunsRound, ARunOverTheFirstPlaceIsOneAndEndsBeyondTheLast) {
  EXPECT_EQ(endsOf({1, 0, 0, 1, 1}), (Ends{{3, 5}}));
  EXPECT_EQ(endsOf({0, 1, 0, 0, 0, 1}, 1), (Ends{{5, 7}}));
}

TEST(RunsRound, SoManyOthersDivideNoRun) {
  EXPECT_EQ(endsOf({0, 1, 0, 0, 1, 0, 0, 0}, 2), (Ends{{1, 4}}));
  EXPECT_EQ(endsOf({0, 1, 0, 0, 1, 0, 0, 0}, 1), (Ends{{1, 1}, {4, 4}}));
}

TEST(RunsRound, AWholeRingIsOneRun) {
  const auto runs = runsRound({1, 1, 1});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs.front().last - runs.front().first, 2U);
}

TEST(RunsBetween, GoFromOneBeginToTheNextRoundTheRing) {
  const auto runs = runsBetween(10, [](std::size_t k) { return k == 2 || k == 3 || k == 7; });
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_TRUE(runs[0].first == 2 && runs[0].last == 2);
  EXPECT_TRUE(runs[1].first == 3 && runs[1].last == 6);
  EXPECT_TRUE(runs[2].first == 7 && runs[2].last == 11);
}

TEST(RunsBetween, AreNoneWithFewerThanTwoBegins) {
  EXPECT_TRUE(runsBetween(10, [](std::size_t k) { return k == 2; }).empty());
  EXPECT_TRUE(runsBetween(0, [](std::size_t) { return true; }).empty());
}

}  // namespace tank_datum::ring_runs_test
