#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "io/block.h"
#include "support/read_scans.h"

/// Scan::fromBlocks: points that somebody else reads.
namespace tank_datum {
namespace {

using read_scans::passOf;

/// Blocks of given sizes; x is the row, the setup the number of the block. Every thousandth row is not finite.
struct Made {
  std::vector<std::size_t> sizes;
  int starts = 0;

  ScanBlocks blocks() {
    ScanBlocks blocks;
    blocks.tells_setups = true;
    blocks.coordinate_step = 0.002;
    blocks.start = [this]() -> ScanBlocks::Next {
      ++starts;
      return [this, at = std::size_t{0}, row = 0](ScanBlocks::Block& block) mutable {
        if (at == sizes.size()) return false;
        block.points.clear();
        block.setup = static_cast<std::uint32_t>(at);
        for (std::size_t i = 0; i < sizes[at]; ++i, ++row) {
          block.points.emplace_back(row % 1000 == 999 ? std::nan("") : row + 100.0, 2.0, 3.0);
        }
        ++at;
        return true;
      };
    };
    return blocks;
  }
};

TEST(ScanBlocks, AnySizesAreReadInOrderAndAgain) {
  Made made{{10, 0, 40'000, 5'000}};
  const Scan scan = Scan::fromBlocks(made.blocks());
  EXPECT_EQ(scan.size(), 45'010U);  // counted
  EXPECT_EQ(scan.coordinateStep(), 0.002);
  EXPECT_EQ(scan.origin(), Eigen::Vector3d(100, 2, 3));
  const int before = made.starts;
  for (int pass_number = 0; pass_number < 2; ++pass_number) {
    const auto pass = passOf(scan);
    EXPECT_EQ(pass.counts.points, 45'010U);
    EXPECT_EQ(pass.counts.invalid, 45U);
    ASSERT_EQ(pass.setups.size(), 3U);
    EXPECT_EQ(pass.setups.at(2).size(), 40'000U - 40U);
    for (std::size_t i = 1; i < pass.points.size(); ++i) ASSERT_GT(pass.points[i].x(), pass.points[i - 1].x());
  }
  EXPECT_EQ(made.starts, before + 2);
  EXPECT_TRUE(scan.tellsSetups());
  EXPECT_EQ(scan.setupName({0, 2}), "2");
  std::size_t largest = 0;
  scan.forEachBlock([&](const Points& block) { largest = std::max(largest, block.size()); });
  EXPECT_LE(largest, kBlockRows);
}

TEST(ScanBlocks, ASizeSaidIsNotCounted) {
  Made made{{10}};
  ScanBlocks blocks = made.blocks();
  blocks.size = 10;
  blocks.tells_setups = false;
  const Scan scan = Scan::fromBlocks(blocks);
  EXPECT_EQ(made.starts, 1);  // for the origin
  EXPECT_EQ(scan.size(), 10U);
  EXPECT_FALSE(scan.tellsSetups());
}

TEST(ScanBlocks, EveryNthAndProgress) {
  Made made{{50'000}};
  Scan scan = Scan::fromBlocks(made.blocks());
  std::uint64_t told = 0;
  scan.setProgress([&told](std::uint64_t rows) { told = rows; });
  const Points some = scan.everyNth(7);
  EXPECT_EQ(told, 50'000U);
  EXPECT_NEAR(static_cast<double>(some.size()), 49'950.0 / 7.0, 8.0);
}

TEST(ScanBlocks, WhatASourceThrowsComesBack) {
  ScanBlocks blocks;
  EXPECT_NE(pcd_files::errorOf([&] { Scan::fromBlocks(blocks); }, Error::Kind::Option).find("start"),
            std::string::npos);
  int passes = 0;
  blocks.size = 2;
  blocks.start = [&passes]() -> ScanBlocks::Next {
    if (++passes > 1) throw std::runtime_error("cancelled");
    return [at = 0](ScanBlocks::Block& block) mutable {
      block.points = {{1, 2, 3}};
      return at++ < 2;
    };
  };
  const Scan scan = Scan::fromBlocks(blocks);
  EXPECT_THROW(passOf(scan), std::runtime_error);
}

}  // namespace
}  // namespace tank_datum
