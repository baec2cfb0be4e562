#include "core/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace tank_datum::parallel_test {

TEST(ForEachIndex, DoesEachOnce) {
  for (const int threads : {0, 1, 3}) {
    std::vector<int> done(1000, 0);
    forEachIndex(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
  }
  forEachIndex(0, 0, [](std::size_t) { ADD_FAILURE(); });
}

TEST(ForEachIndex, UsesAsManyThreadsAsItIsTold) {
  for (const int threads : {1, 3}) {
    std::mutex mutex;
    std::condition_variable another;
    std::set<std::thread::id> seen;
    forEachIndex(300, threads, [&](std::size_t) {  // nobody goes on before all have come
      std::unique_lock lock(mutex);
      seen.insert(std::this_thread::get_id());
      another.notify_all();
      const auto all = [&] { return seen.size() >= static_cast<std::size_t>(threads); };
      EXPECT_TRUE(another.wait_for(lock, std::chrono::seconds(20), all));
    });
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(threads));
  }
}

TEST(ForEachIndex, ThrowsWhatTheWorkThrowsAndStops) {
  std::atomic<int> calls{0};
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 3) throw std::out_of_range("three");
  };
  EXPECT_THROW(forEachIndex(1000, 1, work), std::out_of_range);
  EXPECT_EQ(calls, 4);
  EXPECT_THROW(forEachIndex(1000, 2, work), std::out_of_range);
}

/// Where the machine gives no thread more those that there are do the work.
TEST(ForEachIndex, InsideAnotherIsDoneByTheThreadThatAsks) {
  std::vector<int> done(64, 0);
  forEachIndex(8, 4, [&](std::size_t outer) {
    const auto asks = std::this_thread::get_id();
    forEachIndex(8, 4, [&](std::size_t inner) {
      EXPECT_EQ(std::this_thread::get_id(), asks);
      ++done[8 * outer + inner];
    });
  });
  EXPECT_EQ(done, std::vector<int>(64, 1));
}

/// Callers in several threads do not wait for each other.
TEST(ForEachIndex, FromSeveralThreadsAtOnce) {
  std::vector<std::vector<int>> done(4, std::vector<int>(500, 0));
  std::vector<std::thread> callers;
  for (auto& own : done) {
    callers.emplace_back([&own] {
      for (int repeat = 0; repeat < 50; ++repeat) forEachIndex(own.size(), 3, [&own](std::size_t i) { ++own[i]; });
    });
  }
  for (auto& caller : callers) caller.join();
  for (const auto& own : done) EXPECT_EQ(own, std::vector<int>(500, 50));
}

TEST(ForEachIndex, OneThreadIsTheCallers) {
  const auto caller = std::this_thread::get_id();
  forEachIndex(100, 1, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

TEST(ForEachRun, GivesEachIndexOnceInRunsThatAreNotEmpty) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{7}, std::size_t{1000}}) {
    for (const int threads : {1, 3}) {
      std::vector<int> done(count, 0);
      forEachRun(count, threads, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++done[i];
      });
      EXPECT_EQ(done, std::vector<int>(count, 1));
    }
  }
}

TEST(CancelScope, EndsTheLoopsOfItsThreadOnceTheFlagIsSet) {
  std::atomic<bool> given_up{false};
  std::atomic<int> calls{0};
  const auto work = [&](std::size_t i) {
    ++calls;
    if (i == 10) given_up = true;
  };
  {
    const CancelScope cancel(given_up);
    EXPECT_THROW(forEachIndex(1000, 1, work), GivenUp);
    EXPECT_EQ(calls, 11);
    EXPECT_THROW(forEachRun(1000, 2, [&](std::size_t, std::size_t) { ADD_FAILURE(); }), GivenUp);
  }
  forEachIndex(1000, 2, work);
  EXPECT_EQ(calls, 1011);
}

TEST(ThreadScope, IsWhatNoNumberMeansUntilItEnds) {
  const int cores = threadCount(0);
  {
    const ThreadScope outer(3);
    EXPECT_EQ(threadCount(0), 3);
    EXPECT_EQ(threadCount(5), 5);
    {
      const ThreadScope inner(1);
      const auto caller = std::this_thread::get_id();
      forEachIndex(100, 0, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
      const ThreadScope none(0);
      EXPECT_EQ(threadCount(0), 1);
    }
    EXPECT_EQ(threadCount(0), 3);
  }
  EXPECT_EQ(threadCount(0), cores);
}

}  // namespace tank_datum::parallel_test
