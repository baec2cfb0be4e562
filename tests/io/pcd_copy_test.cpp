#include "io/pcd_copy.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "io/pcd_header.h"
#include "support/read_scans.h"

namespace tank_datum::pcd_copy_test {

using pcd_files::errorOf;
using pcd_files::Folder;
using read_scans::passOf;

/// Points about a place, to the last bit what doubles are there; setups in turns of so many.
ScanBlocks blocksAt(const Eigen::Vector3d& place, std::size_t count, std::size_t turn) {
  ScanBlocks blocks;
  blocks.tells_setups = true;
  blocks.coordinate_step = 0.0005;
  blocks.setups = {{3, {"north side", Eigen::Vector3d(place.x() + 0.1, 2, 3)}}, {5, {"5", std::nullopt}}};
  blocks.start = [=]() -> ScanBlocks::Next {
    return [=, random = std::mt19937_64(1), given = false](ScanBlocks::Block& block) mutable {
      if (given) return false;
      std::uniform_real_distribution<double> offset(-40.0, 40.0);
      block = {};
      for (std::size_t i = 0; i < count; ++i) {
        block.points.push_back(place + Eigen::Vector3d(offset(random), offset(random), 0.1 * offset(random)));
        block.setups.push_back(i / turn % 2 == 0 ? 3 : 5);
      }
      given = true;
      return true;
    };
  };
  return blocks;
}

void expectSame(const Scan& copy, const Scan& scan) {
  EXPECT_EQ(copy.origin(), scan.origin());
  EXPECT_EQ(copy.coordinateStep(), scan.coordinateStep());
  EXPECT_EQ(copy.setups().size(), scan.setups().size());
  for (const SetupKey setup : scan.setups()) {
    EXPECT_EQ(copy.setupName(setup), scan.setupName(setup));
    EXPECT_EQ(copy.setupOrigin(setup), scan.setupOrigin(setup));
  }
  for (const std::uint64_t n : {1U, 3U}) {
    const auto found = passOf(copy, 2, n), expected = passOf(scan, 2, n);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.setups, expected.setups);
  }
}

TEST(PcdCopy, IsTheScanToTheLastBit) {
  const Folder folder;
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0.3, -0.7, 0), Eigen::Vector3d(512'034.7, 5'412'877.1, 211), Eigen::Vector3d(-130, 170, 40)}) {
    const Scan scan = Scan::fromBlocks(blocksAt(place, 40'000, 7'000));
    EXPECT_EQ(copyToPcd(scan, folder.path("a.pcd"), {}), 40'000U);
    expectSame(Scan::open({folder.path("a.pcd")}), scan);
  }
}

TEST(PcdCopy, StandsNearAPlaceOfWholeHundreds) {
  const Folder folder;
  const Scan scan = Scan::fromBlocks(blocksAt({512'034.7, -5'412'877.1, 20}, 100, 7));
  copyToPcd(scan, folder.path("a.pcd"), {{}, {}, "a comment"});
  const PcdHeader header = readPcdHeader(folder.path("a.pcd"));
  EXPECT_EQ(header.notes.origin[0], 100.0 * std::trunc(scan.origin().x() / 100.0));
  EXPECT_EQ(header.notes.origin[1], 100.0 * std::trunc(scan.origin().y() / 100.0));
  EXPECT_LT(header.notes.origin[1], -5e6);
  EXPECT_EQ(header.notes.origin[2], 0.0);
  EXPECT_EQ(header.notes.step, 0.0005);
  EXPECT_EQ(header.columns[0].size, 8);
  EXPECT_EQ(header.columns[3].name, "setup");
  EXPECT_NE(pcd_files::readAll(folder.path("a.pcd")).find("\n# a comment\n"), std::string::npos);
}

/// 0.1 less a million is no double: the copy of such points stands about zero.
TEST(PcdCopy, OfPointsThatDoNotComeBackHasNoOrigin) {
  const Folder folder;
  ScanBlocks blocks = blocksAt({0, 0, 0}, 0, 1);
  blocks.start = [] {
    return [given = false](ScanBlocks::Block& block) mutable {
      block = {};
      for (int i = 0; i < 50; ++i) block.points.emplace_back(1'000'050.0 + i, 3, 4);
      block.points.emplace_back(0.1, 3, 4);
      block.setups.assign(block.points.size(), 5);
      return std::exchange(given, true) == false;
    };
  };
  const Scan scan = Scan::fromBlocks(blocks);
  ASSERT_GT(scan.origin().x(), 1e6);
  EXPECT_EQ(copyToPcd(scan, folder.path("a.pcd"), {}), 51U);
  EXPECT_EQ(readPcdHeader(folder.path("a.pcd")).notes.origin, (std::array<double, 3>{}));
  expectSame(Scan::open({folder.path("a.pcd")}), scan);
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(PcdCopy, OfFilesHasASetupForEachAndEachLabel) {
  const Folder folder;
  const std::vector<pcd_files::Field> labelled = {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}, {"scan_id", 'I', 4}};
  const std::vector<std::string> files = {
      folder.file("a.pcd", pcd_files::pcd(labelled, {{1, 2, 3, 9}, {4, 5, 6, -1}, {7, 8, 9, 9}}, "binary")),
      folder.file("b.pcd", pcd_files::pcd(pcd_files::kXyzFloat, {{1, 1, 1}}, "ascii"))};
  const Scan scan = Scan::open(files);
  std::uint64_t told = 0;
  EXPECT_EQ(copyToPcd(scan, folder.path("copy.pcd"), {{}, [&told](std::uint64_t points) { told = points; }, ""}), 4U);
  EXPECT_EQ(told, 4U);
  const Scan copy = Scan::open({folder.path("copy.pcd")});
  EXPECT_EQ(passOf(copy).points, passOf(scan).points);
  std::vector<std::string> names;
  for (const SetupKey setup : copy.setups()) names.push_back(copy.setupName(setup));
  EXPECT_EQ(names, (std::vector<std::string>{"a:9", "a:none", "b"}));
}

TEST(PcdCopy, OfSomePoints) {
  const Folder folder;
  const Scan scan = Scan::fromPoints({{100, 2, 3}, {101, 2, 3}, {102, 2, 3}});
  const double least = 101 - scan.origin().x();
  const auto wanted = [least](const Eigen::Vector3d& point) { return point.x() >= least; };
  EXPECT_EQ(copyToPcd(scan, folder.path("a.pcd"), {wanted, {}, ""}), 2U);
  EXPECT_EQ(passOf(Scan::open({folder.path("a.pcd")})).points, (Points{{101, 2, 3}, {102, 2, 3}}));
}

std::string withNote(const std::string& note) {
  return "# tank_datum: " + note + "\n" + pcd_files::pcd(pcd_files::kXyzFloat, {{1, 2, 3}}, "binary");
}

TEST(PcdNotes, AreAppliedInEveryEncoding) {
  const Folder folder;
  for (const std::string encoding : {"binary", "ascii", "binary_compressed"}) {
    const std::string bytes = "# tank_datum: origin 300000.5 0 -2\n# tank_datum: step 0.25\n" +
                              pcd_files::pcd(pcd_files::kXyzFloat, {{1, 2, 3}}, encoding);
    const Scan scan = Scan::open({folder.file("a.pcd", bytes)});
    EXPECT_EQ(passOf(scan).points, (Points{{300001.5, 2, 1}})) << encoding;
    EXPECT_EQ(scan.coordinateStep(), 0.25);
  }
}

TEST(PcdNotes, FullCoordinatesComeFirst) {
  const Folder folder;
  std::vector<pcd_files::Field> fields = pcd_files::kXyzFloat;
  for (const char* name : kFullNames) fields.push_back({name, 'F', 8});
  const std::string bytes =
      "# tank_datum: origin 100 0 0\n" + pcd_files::pcd(fields, {{1, 2, 3, 101.25, 2.25, 3.25}}, "binary");
  EXPECT_EQ(passOf(Scan::open({folder.file("a.pcd", bytes)})).points, (Points{{101.25, 2.25, 3.25}}));
}

TEST(PcdNotes, ThatCannotBeReadAreRefused) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> lies = {{"origin 1 2", "expected numbers"},
                                                                 {"origin 1 2 nan", "expected numbers"},
                                                                 {"step 0", "expected a number > 0"},
                                                                 {"setup x is a", "expected the number of a setup"},
                                                                 {"setup 1 is", "expected a name"},
                                                                 {"setup 1 at 1 2", "expected numbers"},
                                                                 {"setup 1 was 2", "expected setup N is"},
                                                                 {"tilt 3", "expected origin, step or setup"},
                                                                 {"setup 5000000000 is a", "number of a setup"}};
  for (const auto& [note, expected] : lies) {
    const std::string path = folder.file("a.pcd", withNote(note));
    const std::string said = errorOf([&] { Scan::open({path}); });
    EXPECT_NE(said.find("header comment of " + path + ", \"" + note + "\""), std::string::npos) << said;
    EXPECT_NE(said.find(expected), std::string::npos) << said;
  }
}

TEST(PcdNotes, TooManyNamesAreRefused) {
  const Folder folder;
  ScanBlocks blocks = blocksAt({0, 0, 0}, 10, 1);
  for (std::uint32_t i = 10; i < 3000; ++i) blocks.setups[i] = {"a name of twenty odd letters", std::nullopt};
  blocks.start_some = [start = blocks.start](const std::vector<std::uint32_t>&) { return start(); };
  const Scan scan = Scan::fromBlocks(blocks);
  const std::string said = errorOf([&] { copyToPcd(scan, folder.path("a.pcd"), {}); }, Error::Kind::Option);
  EXPECT_NE(said.find("setups, 2991, expected so many that their names fit into 65536 bytes"), std::string::npos)
      << said;
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(LocalOrigin, IsAWholeHundredTowardsZero) {
  EXPECT_EQ(localOrigin({99.9, -99.9, 512'199.5}), Eigen::Vector3d(0, 0, 512'100));
  EXPECT_EQ(localOrigin({-250, 100, 0}), Eigen::Vector3d(-200, 100, 0));
}

}  // namespace tank_datum::pcd_copy_test
