#include <gtest/gtest.h>

#include <algorithm>

#include "support/read_scans.h"

/// Scan::everyNth of points that somebody else reads in parts, of which some can be left unread.
namespace tank_datum::scan_parts_test {

using read_scans::passOf;

/// Parts of twenty rows, of which a pass may leave some unread; x is the part, `every` what was asked for last.
ScanBlocks inParts(std::uint64_t parts, std::uint64_t& every) {
  ScanBlocks blocks;
  blocks.size = 20 * parts;
  blocks.parts = parts;
  blocks.start_every = [parts, &every](std::uint64_t n) -> ScanBlocks::Next {
    every = n;
    return [parts, n, part = std::uint64_t{0}](ScanBlocks::Block& block) mutable {
      if (part >= parts) return false;
      block.points.assign(20, {static_cast<double>(part), 1, 1});
      block.left_out = 20 * (std::min(parts, part + n) - part - 1);
      part += n;
      return true;
    };
  };
  blocks.start = [begin = blocks.start_every] { return begin(1); };
  return blocks;
}

TEST(ScanParts, PartsAreLeftUnreadWhereSomeHundredAreLookedAt) {
  std::uint64_t every = 0, told = 0;
  Scan scan = Scan::fromBlocks(inParts(1600, every));
  scan.setProgress([&told](std::uint64_t rows) { told = rows; });
  const Points some = scan.everyNth(9);
  EXPECT_EQ(every, 4U);
  EXPECT_EQ(told, 32'000U);
  EXPECT_NEAR(static_cast<double>(some.size()), 400.0 * 20.0 / 3.0, 2.0);
  EXPECT_GT(some.back().x() - some.front().x(), 1580.0);
  scan.everyNth(3);
  EXPECT_EQ(every, 3U);
  EXPECT_EQ(passOf(scan, 1, 9).counts.left_out, 0U);  // a pass that counts reads all
  EXPECT_EQ(every, 1U);
}

TEST(ScanParts, FewPartsAreAllRead) {
  std::uint64_t every = 0;
  Scan::fromBlocks(inParts(799, every)).everyNth(9);
  EXPECT_EQ(every, 1U);
  ScanBlocks blocks = inParts(1600, every);
  blocks.start_every = nullptr;
  every = 0;
  EXPECT_EQ(Scan::fromBlocks(blocks).everyNth(1).size(), 32'000U);
  EXPECT_EQ(every, 1U);
}

}  // namespace tank_datum::scan_parts_test
