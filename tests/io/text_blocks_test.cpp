#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "support/read_scans.h"

/// PTS and PTX: setups one after the other in a text, and counts and poses that lie.
namespace tank_datum::text_blocks_test {

using read_scans::passOf;
using read_scans::refusalOf;

void expectRefusal(const std::string& text, const std::string& part) {
  const std::string message = refusalOf(text);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Pts, OneBlockIsOneSetup) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({folder.file("hall.txt", "2\n1 2 3 -1035 97 59 38\n4.5 5 6 -1 1 1 1")});
  EXPECT_EQ(scan.size(), 2U);
  EXPECT_EQ(passOf(scan).points, (Points{{1, 2, 3}, {4.5, 5, 6}}));
  EXPECT_FALSE(scan.tellsSetups());
  EXPECT_EQ(scan.setupName({0, 0}), "hall");
}

TEST(Pts, BlocksAreSetups) {
  const pcd_files::Folder folder;
  const std::string text = "2\r\n1 2 3 4\r\n5 6 7 8\r\n\r\n0\n 3 \n1 1 1\n2 2 2\nnan 3 3\n1\n9 9 9\n";
  const Scan scan = Scan::open({folder.file("a.pts", text)});
  EXPECT_EQ(scan.size(), 6U);
  const auto pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 6U);
  EXPECT_EQ(pass.counts.invalid, 1U);
  ASSERT_EQ(pass.setups.size(), 3U);
  EXPECT_EQ(pass.setups.at(0), (Points{{1, 2, 3}, {5, 6, 7}}));
  EXPECT_EQ(pass.setups.at(1), (Points{{1, 1, 1}, {2, 2, 2}}));
  EXPECT_EQ(pass.setups.at(2), (Points{{9, 9, 9}}));
  EXPECT_TRUE(scan.tellsSetups());
  EXPECT_EQ(scan.setupName({0, 2}), "2");
  EXPECT_FALSE(scan.setupOrigin({0, 1}));
}

TEST(Pts, LinesBeyondTheCountArePoints) {
  const pcd_files::Folder folder;
  const auto pass = passOf(Scan::open({folder.file("a.pts", "1\n1 2 3\n4 5 6\n1\n7 8 9\n")}));
  EXPECT_EQ(pass.points, (Points{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(pass.setups.at(1).size(), 1U);
}

TEST(Pts, ACommentNamesItsColumns) {
  const pcd_files::Folder folder;
  const auto pass = passOf(Scan::open({folder.file("a.asc", "//Z;X;Y\n2\n3;1;2\n6;4;5\n")}));
  EXPECT_EQ(pass.points, (Points{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Pts, CountsThatLie) {
  expectRefusal("3\n1 2 3\n4 5 6\n", "line 1 of ");
  expectRefusal("3\n1 2 3\n4 5 6\n", "3 points, expected at most 2, the lines that follow");
  expectRefusal("1\n1 2 3\n1099511627776\n4 5 6\n", "line 3 of ");
  expectRefusal("9223372036854775807\n4 5 6\n", "at most 1, the lines that follow");
  expectRefusal("2\n1 2 3\n4 5\n", "line 3 of ");
  expectRefusal("2\n1,5 2 3\n4 5 6\n", "decimal points, not commas");
  const pcd_files::Folder folder;
  EXPECT_EQ(passOf(Scan::open({folder.file("none.pts", "0\n")})).counts.points, 0U);
}

/// A scan of 2 columns and 3 rows whose second beam did not return.
std::string ptx(const std::string& position, const std::string& matrix) {
  return "2\n3\n" + position + "\n1 0 0\n0 1 0\n0 0 1\n" + matrix +
         "1 0 0 0.5\n0 0 0 0.5\n0 2 0 0.5 1 2 3\n0 0 3 0.5\n1 1 1 0.5\nnan 0 0 0.5\n";
}

const std::string kIdentity = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
/// A quarter turn from x to y, then a step.
const std::string kQuarter = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n600000.5 100 20 1\n";

TEST(Ptx, PosesAreAppliedAndScansAreSetups) {
  const pcd_files::Folder folder;
  const std::string text = ptx("0 0 0", kIdentity) + ptx("600000.5 100 20", kQuarter) + ptx("0 0 0", kQuarter);
  const Scan scan = Scan::open({folder.file("a.ptx", text)});
  EXPECT_EQ(scan.size(), 18U);
  const auto pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 18U);
  EXPECT_EQ(pass.counts.invalid, 6U);
  ASSERT_EQ(pass.setups.size(), 3U);
  read_scans::expectNear(pass.setups.at(0), {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}}, 1e-12);
  const Points turned = {{600000.5, 101, 20}, {599998.5, 100, 20}, {600000.5, 100, 23}, {599999.5, 101, 21}};
  read_scans::expectNear(pass.setups.at(1), turned, 1e-9);
  read_scans::expectNear(pass.setups.at(2), turned, 1e-9);
  EXPECT_EQ(scan.setupName({0, 1}), "1");
  EXPECT_FALSE(scan.setupOrigin({0, 0}));  // zeros are what writers put who do not know
  ASSERT_TRUE(scan.setupOrigin({0, 1}));
  EXPECT_EQ(*scan.setupOrigin({0, 1}) + scan.origin(), Eigen::Vector3d(600000.5, 100, 20));
  EXPECT_EQ(*scan.setupOrigin({0, 2}) + scan.origin(), Eigen::Vector3d(600000.5, 100, 20));
}

TEST(Ptx, UnitsScaleThePoseToo) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({folder.file("a.ptx", ptx("1 2 3", kQuarter))}, 0.001);
  read_scans::expectNear({passOf(scan).points[0]}, {{600.0005, 0.101, 0.02}}, 1e-12);
  EXPECT_LE((*scan.setupOrigin({0, 0}) + scan.origin() - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
  EXPECT_FALSE(scan.tellsSetups());  // one scan
  EXPECT_EQ(scan.setupName({0, 0}), "a");
}

TEST(Ptx, EmptyScansArePassedOver) {
  const pcd_files::Folder folder;
  const std::string none = "0\n9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + kIdentity;
  const Scan scan = Scan::open({folder.file("a.ptx", none + ptx("5 6 7", kIdentity) + none + ptx("8 9 1", kIdentity))});
  EXPECT_EQ(passOf(scan).setups.size(), 2U);
  EXPECT_LE((*scan.setupOrigin({0, 1}) + scan.origin() - Eigen::Vector3d(8, 9, 1)).norm(), 1e-12);
}

/// A turn about z written with entries off by e.
std::string stretched(double e) {
  char text[200];
  std::snprintf(text, sizeof text, "%.9f 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", 1.0 + e);
  return text;
}

TEST(Ptx, PosesThatAreNone) {
  const pcd_files::Folder folder;
  EXPECT_EQ(Scan::open({folder.file("a.ptx", ptx("0 0 0", stretched(0.00002)))}).size(), 6U);  // five decimals
  expectRefusal(ptx("0 0 0", stretched(0.00003)), "line 7 of ");
  expectRefusal(ptx("0 0 0", stretched(-0.00003)), "a matrix that is no rotation, expected rows of length 1");
  expectRefusal(ptx("0 0 0", "1 0 0 0\n0 1 0 0\n0 0 2 0\n0 0 0 1\n"), "no rotation");
  expectRefusal(ptx("0 0 0", "1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n"), "no rotation");  // mirrored
  expectRefusal(ptx("0 0 0", "0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n"), "no rotation");
  expectRefusal(ptx("0 0 0", "1 0 0 5\n0 1 0 6\n0 0 1 7\n0 0 0 1\n"), "another last column of the matrix");
  expectRefusal(ptx("0 0 0", "1 0 0 0\n0 1 0 0\n0 0 1 0\nnan 0 0 1\n"), "line 10 of ");
  expectRefusal(ptx("0 0 0", "1 0 0\n0 1 0\n0 0 1\n0 0 0\n"), "a row of the matrix, 4 numbers");
  expectRefusal(ptx("0 0", kIdentity), "the scanner's position, 3 numbers");
  expectRefusal(ptx("0 0 0 0", kIdentity), "the scanner's position, 3 numbers");
}

TEST(Ptx, CountsThatLie) {
  const std::string good = ptx("0 0 0", kIdentity);
  const auto first = [&good](const std::string& lines) { return lines + good.substr(4); };
  expectRefusal(first("3\n3\n"), "3 columns of 3 points, expected at most 6 points, the lines that follow");
  expectRefusal(first("4294967296\n4294967296\n"), "at most 6 points");  // 2^64
  expectRefusal(first("1048576\n1048576\n"), "at most 6 points");        // 2^40
  expectRefusal(first("2\n2\n"), "line 15 of ");
  expectRefusal(first("2\n2\n"), "expected the columns of a scan");
  expectRefusal(good + "5\n", "the end of the file, expected the rows of a scan");
  expectRefusal(good + "5\n5\n0 0 0\n", "the end of the file, expected an axis of the scanner");
}

TEST(Ptx, ALongFileInAnyThread) {
  const pcd_files::Folder folder;
  std::string text;
  for (int scan = 0; scan < 3; ++scan) {
    text += "100\n400\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n" + std::to_string(scan) + " 0 0 1\n";
    for (int i = 0; i < 40'000; ++i) {
      text += i % 4 == 1 ? "0 0 0 0.5\n" : std::to_string(i) + ".5 22222.25 33333.5 0.123\n";
    }
  }
  const Scan scan = Scan::open({folder.file("a.ptx", text)});
  const auto one = passOf(scan, 1), two = passOf(scan, 2);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.counts.points, 120'000U);
  EXPECT_EQ(one.counts.invalid, 30'000U);
  for (std::uint32_t label = 0; label < 3; ++label) {
    const Points& points = one.setups.at(label);
    ASSERT_EQ(points.size(), 30'000U);
    EXPECT_EQ(points[0].x(), 0.5 + label);
    EXPECT_EQ(points.back().x(), 39999.5 + label);
  }
}

TEST(TextBlocks, CutAnywhereOrWithAnyByteChanged) {
  const std::string first = ptx("1 2 3", kQuarter), good = first + ptx("0 0 0", kIdentity);
  const auto is_whole = [](std::size_t at, std::size_t end) { return at + 5 >= end && at <= end; };  // without " 0.5"
  for (std::size_t at = 1; at < good.size(); ++at) {
    if (!is_whole(at, first.size()) && !is_whole(at, good.size())) {
      const std::string message = refusalOf(good.substr(0, at));
      EXPECT_FALSE(message.empty()) << at;
    }
    for (const char byte : {'\0', '\n', '-', ' ', '9', '\xff'}) {
      std::string bytes = good;
      bytes[at] = byte;
      read_scans::readHostile(bytes);
    }
  }
}

}  // namespace tank_datum::text_blocks_test
