#include "io/read_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>

namespace tank_datum::read_ahead_test {

/// Blocks 0, 1, 2, ... by their setup, and who read them.
struct Counted {
  std::uint32_t count;
  std::atomic<std::uint32_t> read{0};
  std::set<std::thread::id> readers{};

  ScanBlocks::Next next() {
    return [this](ScanBlocks::Block& block) {
      readers.insert(std::this_thread::get_id());
      if (read == count) return false;
      block.setup = read++;
      return true;
    };
  }

  /// Whether so many come to be read within a second.
  bool comeTo(std::uint32_t wanted) const {
    for (int i = 0; i < 1000 && read < wanted; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return read == wanted;
  }
};

TEST(ReadAhead, GivesEveryBlockInOrderFromOneOtherThread) {
  Counted blocks{50};
  ReadAhead ahead(blocks.next());
  ScanBlocks::Block block;
  for (std::uint32_t i = 0; i < 50; ++i) {
    ASSERT_TRUE(ahead.take(block));
    EXPECT_EQ(block.setup, i);
  }
  EXPECT_FALSE(ahead.take(block));
  EXPECT_FALSE(ahead.take(block));
  EXPECT_EQ(blocks.readers.size(), 1U);
  EXPECT_EQ(blocks.readers.count(std::this_thread::get_id()), 0U);
}

TEST(ReadAhead, IsOneAheadFromTheSecondBlockOn) {
  Counted blocks{50};
  ReadAhead ahead(blocks.next());
  ScanBlocks::Block block;
  ahead.take(block);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(blocks.read, 1U);
  ahead.take(block);
  EXPECT_TRUE(blocks.comeTo(3));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(blocks.read, 3U);
}

TEST(ReadAhead, WhoTakesABlockFinishesIt) {
  std::set<std::thread::id> finishers;
  std::uint32_t read = 0;
  ReadAhead ahead([&](ScanBlocks::Block& block) {
    block.setup = read;
    block.finish = [&finishers](ScanBlocks::Block& whole) {
      finishers.insert(std::this_thread::get_id());
      whole.points.assign(whole.setup + 1, Eigen::Vector3d::Zero());
      return false;
    };
    if (read % 2 == 1) block.finish = nullptr, block.points.clear();
    return ++read <= 4;
  });
  ScanBlocks::Block block;
  for (const std::size_t rows : {1U, 0U, 3U, 0U}) {
    ASSERT_TRUE(ahead.take(block));
    EXPECT_EQ(block.points.size(), rows);
  }
  EXPECT_FALSE(ahead.take(block));
  EXPECT_EQ(finishers, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ReadAhead, ABlockMayBeFinishedSomeRowsAtATime) {
  std::uint32_t read = 0;
  ReadAhead ahead([&](ScanBlocks::Block& block) {
    block.setup = read;
    block.finish = [left = read](ScanBlocks::Block& some) mutable {
      some.points.assign(left, Eigen::Vector3d::Zero());
      return left-- > 1;
    };
    return ++read <= 3;
  });
  ScanBlocks::Block block;
  for (const auto& [setup, rows] : {std::pair{0U, 0U}, {1U, 1U}, {2U, 2U}, {2U, 1U}}) {
    ASSERT_TRUE(ahead.take(block));
    EXPECT_EQ(block.setup, setup);
    EXPECT_EQ(block.points.size(), rows);
  }
  EXPECT_FALSE(ahead.take(block));
}

TEST(ReadAhead, ThrowsWhatTheSourceThrowsWhenThatBlockIsAskedFor) {
  int read = 0;
  ReadAhead ahead([&read](ScanBlocks::Block&) -> bool {
    if (++read == 3) throw std::runtime_error("third");
    return true;
  });
  ScanBlocks::Block block;
  EXPECT_TRUE(ahead.take(block));
  EXPECT_TRUE(ahead.take(block));
  EXPECT_THROW(ahead.take(block), std::runtime_error);
  EXPECT_THROW(ahead.take(block), std::runtime_error);
}

TEST(ReadAhead, MayBeLeftAtAnyBlock) {
  for (const int taken : {0, 1, 2, 7}) {
    Counted blocks{50};
    ReadAhead ahead(blocks.next());
    ScanBlocks::Block block;
    for (int i = 0; i < taken; ++i) ahead.take(block);
  }
}

}  // namespace tank_datum::read_ahead_test
