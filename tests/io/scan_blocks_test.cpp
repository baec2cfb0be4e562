#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "io/block.h"
#include "support/read_scans.h"

/// Scan::fromBlocks: points that somebody else reads.
namespace tank_datum::scan_blocks_test {

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

class ScanBlocksLater : public testing::TestWithParam<std::size_t> {};

TEST_P(ScanBlocksLater, PointsMayComeWithTheLookAtThem) {
  Made made{{10, 0, 40'000, 5'000}};
  ScanBlocks blocks = made.blocks(), later = blocks;
  later.start = [start = blocks.start]() -> ScanBlocks::Next {
    return [next = start()](ScanBlocks::Block& block) {
      ScanBlocks::Block whole;
      if (!next(whole)) return false;
      block.points.clear();
      block.finish = [whole, done = std::size_t{0}](ScanBlocks::Block& asked) mutable {
        const std::size_t first = done;
        done = std::min(whole.points.size(), first + GetParam());
        asked.points.assign(whole.points.data() + first, whole.points.data() + done);
        asked.setup = whole.setup;
        return done < whole.points.size();
      };
      return true;
    };
  };
  const auto [at_once, then] = std::pair(Scan::fromBlocks(blocks), Scan::fromBlocks(later));
  EXPECT_EQ(then.size(), 45'010U);
  EXPECT_EQ(passOf(then).points, passOf(at_once).points);
  EXPECT_EQ(passOf(then, 1, 3).points, passOf(at_once, 1, 3).points);
}

INSTANTIATE_TEST_SUITE_P(Rows, ScanBlocksLater, testing::Values(1'000'000, 16'384, 7'000),
                         [](const auto& at_once) { return "Of" + std::to_string(at_once.param); });

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

/// Two blocks a pass: three points of setups 4 and 9 in turns beside rows that are none, and two of setup 9.
ScanBlocks labelled(int& passed_over) {
  using Wanted = std::vector<std::uint32_t>;
  ScanBlocks blocks;
  blocks.tells_setups = true;
  blocks.setups = {{4, {"north", Eigen::Vector3d(1, 2, 3)}}, {9, {"", std::nullopt}}};
  const auto begin = [&passed_over](const Wanted& wanted) -> ScanBlocks::Next {
    return [&passed_over, wanted, at = 0](ScanBlocks::Block& block) mutable {
      block = {};
      if (at == 2) return false;
      const bool first = at++ == 0;
      if (!first && std::find(wanted.begin(), wanted.end(), 9U) == wanted.end()) {
        ++passed_over;
        block.left_out = 2;
        return true;
      }
      block.setup = 9;
      block.points = {{11, 0, 5}, {12, 0, 5}};
      if (!first) return true;
      block.points.emplace_back(13, 0, 5);
      block.setups = {4, 9, 4};
      block.invalid = 20;
      block.left_out = 300;
      return true;
    };
  };
  blocks.start = [begin] { return begin({4, 9}); };
  blocks.start_some = begin;
  return blocks;
}

/// A file that begins as E57 does.
std::string foreignFile(const pcd_files::Folder& folder) {
  return folder.file("tank.e57", "ASTM-E57" + std::string(100, '\0'));
}

ScanOptions readBy(const ScanBlocks& blocks, const std::vector<std::string>& setups = {}) {
  ScanOptions options;
  options.setups = setups;
  options.foreign = [blocks](const ForeignScan& scan) {
    EXPECT_EQ(scan.format, "E57");
    EXPECT_EQ(scan.metres_per_unit, 0.001);
    return blocks;
  };
  return options;
}

TEST(ScanBlocks, PointsOfABlockMayHaveSetupsOfTheirOwn) {
  int passed_over = 0;
  const Scan scan = Scan::fromBlocks(labelled(passed_over));
  EXPECT_EQ(scan.size(), 325U);
  const auto pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 325U);
  EXPECT_EQ(pass.counts.invalid, 20U);
  EXPECT_EQ(pass.counts.left_out, 300U);
  read_scans::expectNear(pass.setups.at(4), {{11, 0, 5}, {13, 0, 5}}, 0.0);
  read_scans::expectNear(pass.setups.at(9), {{12, 0, 5}, {11, 0, 5}, {12, 0, 5}}, 0.0);
  EXPECT_EQ(passed_over, 0);
}

TEST(ScanBlocks, AForeignFileIsReadWithItsNamesAndPlaces) {
  const pcd_files::Folder folder;
  int passed_over = 0;
  const Scan scan = Scan::open({foreignFile(folder)}, 0.001, readBy(labelled(passed_over)));
  EXPECT_EQ(scan.setupName({0, 4}), "north");
  EXPECT_EQ(scan.setupName({0, 9}), "tank");  // of the file itself
  EXPECT_EQ(scan.setupName({0, 5}), "5");
  ASSERT_TRUE(scan.setupOrigin({0, 4}));
  EXPECT_EQ(*scan.setupOrigin({0, 4}) + scan.origin(), Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(scan.setupOrigin({0, 9}));
}

TEST(ScanBlocks, SetupsThatAreNotAskedForAreLeftOut) {
  const pcd_files::Folder folder;
  int passed_over = 0;
  ScanBlocks blocks = labelled(passed_over);
  for (const bool can_pass_over : {true, false}) {
    if (!can_pass_over) blocks.start_some = nullptr;
    const Scan scan = Scan::open({foreignFile(folder)}, 0.001, readBy(blocks, {"north"}));
    EXPECT_EQ(scan.size(), 325U);
    passed_over = 0;
    const auto pass = passOf(scan);
    EXPECT_EQ(passed_over, can_pass_over ? 1 : 0);
    EXPECT_EQ(pass.counts.points, 325U);
    EXPECT_EQ(pass.counts.invalid, 20U);
    EXPECT_EQ(pass.counts.left_out, 303U);
    read_scans::expectNear(pass.points, {{11, 0, 5}, {13, 0, 5}}, 0.0);
  }
}

TEST(ScanBlocks, SetupsThatAreNotThereAreRefused) {
  const pcd_files::Folder folder;
  int passed_over = 0;
  const ScanOptions options = readBy(labelled(passed_over), {"north", "west"});
  const auto message =
      pcd_files::errorOf([&] { Scan::open({foreignFile(folder)}, 0.001, options); }, Error::Kind::Option);
  EXPECT_EQ(message, "io: setups, west, expected names of setups that the scan has: north, tank");
}

TEST(ScanBlocks, AForeignFileThatNobodyReadsIsRefused) {
  const pcd_files::Folder folder;
  EXPECT_NE(pcd_files::errorOf([&] { Scan::open({foreignFile(folder)}); }).find("pip install 'tank_datum[formats]'"),
            std::string::npos);
}

}  // namespace tank_datum::scan_blocks_test
