#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/read_scans.h"

/// Text of columns: what parts them, what names them, and what must not be read as other numbers.
namespace tank_datum::text_columns_test {

using read_scans::passOf;
using read_scans::refusalOf;

read_scans::Pass read(const std::string& text, const std::string& name = "scan.pcd") {
  const pcd_files::Folder folder;
  return passOf(Scan::open({folder.file(name, text)}));
}

const Points kTwo = {{1.5, -2.5, 3.25}, {4e2, 5.125, 0.006}};

void expectTwo(const std::string& text) {
  const auto pass = read(text);
  SCOPED_TRACE(text);
  read_scans::expectNear(pass.points, kTwo, 1e-12);
  EXPECT_EQ(pass.counts.points, 2U) << text;
}

void expectRefusal(const std::string& text, const std::string& part) {
  const std::string message = refusalOf(text);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(TextColumns, SeparatorsAreFound) {
  expectTwo("1.5 -2.5 3.25\n4e2 5.125 0.006\n");
  expectTwo("  1.5\t-2.5   3.25 \n 4e2\t\t+5.125 .006");
  expectTwo("1.5,-2.5,3.25\n4e2,5.125,6e-3\n");
  expectTwo("1.5, -2.5, 3.25\n4e2 , 5.125 ,0.006,\n");
  expectTwo("1.5;-2.5;3.25;9\n4e2; 5.125; 0.006;9\n");
  expectTwo("1.5\t-2.5\t3.25\n4e2\t5.125\t0.006\n");
  expectTwo("\"1.5\",\"-2.5\",\"3.25\"\n\"4e2\",\"5.125\",\"0.006\"\n");
}

TEST(TextColumns, LineEndsBlankLinesAndComments) {
  expectTwo("1.5 -2.5 3.25\r\n4e2 5.125 0.006\r\n");
  expectTwo("1.5 -2.5 3.25\r\n4e2 5.125 0.006\n");
  expectTwo("\n# by hand\n1.5 -2.5 3.25\n  \n// 7 8 9\n4e2 5.125 0.006\n\n\n");
  expectTwo(
      "\xef\xbb\xbf"
      "1.5 -2.5 3.25\n4e2 5.125 0.006\n");
}

TEST(TextColumns, HeadersNameColumns) {
  expectTwo("x y z\n1.5 -2.5 3.25\n4e2 5.125 0.006\n");
  expectTwo("\"X\",\"Y\",\"Z\",\"I\"\n1.5,-2.5,3.25,8\n4e2,5.125,0.006,8\n");
  expectTwo("name,Z,Y,X\np,3.25,-2.5,1.5\n\"q, r\",0.006,5.125,4e2\n");
  expectTwo("Point Name;Northing [m];Easting (m);Elevation\na b;-2.5;1.5;3.25\nc;5.125;4e2;0.006\n");
  expectTwo("height easting northing\n3.25 1.5 -2.5\n0.006 4e2 5.125\n");  // the first is a word of PCD too
  expectTwo("HEIGHT\tN\tE\n3.25\t-2.5\t1.5\n0.006\t5.125\t4e2\n");
  expectTwo("Nr North East Elev\n7 -2.5 1.5 3.25\n8 5.125 4e2 0.006\n");
  expectTwo("E\tN\tH\n1.5\t-2.5\t3.25\n4e2\t5.125\t0.006\n");
  expectTwo("//Z,X,Y\n3.25,1.5,-2.5\n0.006,4e2,5.125\n");
  expectTwo("# z x y\n3.25 1.5 -2.5\n0.006 4e2 5.125\n");
  expectTwo("X,Y,Z\n1.5 -2.5 3.25\n4e2 5.125 0.006\n");
  expectTwo(",x,y,z\n0,1.5,-2.5,3.25\n1,4e2,5.125,0.006\n");  // as tables with an index have it
  expectTwo("\xef\xbb\xbfX Y Z\n1.5 -2.5 3.25\n4e2 5.125 0.006\n");
  EXPECT_EQ(read("x y z\n").counts.points, 0U);
}

TEST(TextColumns, HeadersThatDoNotNameThem) {
  expectRefusal("x y w\n1 2 3\n", "line 1 of ");
  expectRefusal("x y x z\n1 2 3 4\n", "named x, y and z");
  expectRefusal("This is a file\nof words\n", "\"This is a file\", expected PCD, LAS, PLY, PTX, PTS, or text");
  expectRefusal("\n\n1 2\n3 4\n", "line 3 of ");
  expectRefusal("# nothing\n\n", "no line but comments");
  expectRefusal("", "an empty file, expected PCD, LAS");
}

TEST(TextColumns, DecimalCommasAreRefused) {
  for (const char* text : {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "1,5\t2,5\t3,5\n", "1,500, 2,500, 3,500\n",
                           "x;y;z\n1,5;2,5;3,5\n", "1 2 3\n1 2 3\n1 2,5 3\n", "1;2;3\n1;2;3,5\n"}) {
    expectRefusal(text, "expected numbers with decimal points, not commas");
  }
  expectRefusal("1 2 3\n1 2 3\n1 2,5 3\n", "line 3 of ");
  EXPECT_EQ(read("1,5,2,5\n").points, (Points{{1, 5, 2}}));  // four columns
}

TEST(TextColumns, RowsThatAreNone) {
  expectRefusal("1 2 3\n\n# c\n4 5\n", "line 4 of ");
  expectRefusal("1 2 3\n4 5\n", "\"4 5\", expected more columns, up to x, y and z");
  expectRefusal("1,2,3\n4,,6\n", "expected a number");
  expectRefusal("1 2 3\n4 5x 6\n", "\"5x\", expected a number");
  expectRefusal("1 2 3\n4 5 1e999\n", "\"1e999\", expected a number");
  expectRefusal("1 2 3\n4 5 0x10\n", "\"0x10\", expected a number");
  expectRefusal("1 2 3\n" + std::string(700'000, '1') + " 2 3\n", "a line of ");
  expectRefusal("x,y,z\n\"1,2,3\n", "expected a number");
}

TEST(TextColumns, NotFinitePointsAreDroppedAndCounted) {
  const auto pass = read("nan nan nan\n1 2 3\n4 inf 6\n-1.#IND 1.#QNAN 1.#INF00\n7 8 9\n");
  EXPECT_EQ(pass.points, (Points{{1, 2, 3}, {7, 8, 9}}));
  EXPECT_EQ(pass.counts.points, 5U);
  EXPECT_EQ(pass.counts.invalid, 3U);
}

TEST(TextColumns, AColumnOfSetups) {
  const pcd_files::Folder folder;
  for (const char* name : {"setup", "scan_id", "Point_Source_Id"}) {
    const std::string text = std::string("x,") + name + ",y,z\n1,4,2,3\n5,9,6,7\n8,-1,9,9\n5,4,6,7\n";
    const Scan scan = Scan::open({folder.file("a.csv", text)});
    const auto pass = passOf(scan);
    ASSERT_EQ(pass.setups.size(), 3U);
    EXPECT_EQ(pass.setups.at(4), (Points{{1, 2, 3}, {5, 6, 7}}));
    EXPECT_EQ(pass.setups.at(SetupKey::kUnlabelled), (Points{{8, 9, 9}}));
    EXPECT_EQ(scan.setupName({0, 4}), "4");
    EXPECT_TRUE(scan.tellsSetups());
  }
  EXPECT_FALSE(Scan::open({folder.file("b.csv", "x,y,z\n1,2,3\n")}).tellsSetups());
}

TEST(TextColumns, BytesThatAreNoText) {
  expectRefusal(std::string("\x01\x02\x03\n1 2 3\n"), "format of ");
  expectRefusal(std::string("1 2 3\n\0\n", 8), "format of ");
  expectRefusal(
      "\xff\xfe"
      "1 2 3\n",
      "UTF-16 text, expected UTF-8 or ASCII text");
  expectRefusal("ASTM-E57\n1 2 3\n", "E57, expected PCD");
}

TEST(TextColumns, LinesThatEndInCarriageReturnsAloneAreRefused) {
  expectRefusal("x y z\r1 2 3\r4 5 6\r",
                "lines that end in CR alone, expected lines that end in LF or CR LF: tr '\\r' '\\n' < FILE");
  expectRefusal("x y z\n1 2 3\r4 5 6\r", "lines that end in CR alone");
  expectTwo("1.5 -2.5 3.25\r\r\n4e2 5.125 0.006\r");
}

TEST(TextColumns, ATextThatBeginsLikePcdIsOne) {
  expectRefusal("VERSION 0.7\nx y z\n", "header line 2 of ");
  expectRefusal("# .PCD v0.7\nVERSIO 0.7\n1 2 3\n", "header line 2 of ");
  expectRefusal("columns x y z\n1 2 3\n", "header line 2 of ");
  expectRefusal("HEIGHT 1\nx y z\n", "header line 2 of ");
}

TEST(TextColumns, ChunksAreReadInAnyThreadAndKeepTheirOrder) {
  const pcd_files::Folder folder;
  std::string text;
  for (int i = 0; i < 120'000; ++i) {
    text += std::to_string(i) + " " + (i % 777 == 5 ? "nan" : std::to_string(0.25 * i)) + " 3 ";
    text += std::string(static_cast<std::size_t>(i % 37), 'c') + (i % 2 == 0 ? "\n" : "\r\n");
    if (i % 1000 == 0) text += "\n#" + std::string(50, 'c') + "\n";
  }
  const Scan scan = Scan::open({folder.file("a.txt", text)});
  EXPECT_EQ(scan.size(), 120'000U);
  const auto one = passOf(scan, 1), two = passOf(scan, 2);
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.counts.points, 120'000U);
  EXPECT_EQ(one.counts.invalid, 155U);
  ASSERT_EQ(one.points.size(), 119'845U);
  for (std::size_t i = 1; i < one.points.size(); ++i) ASSERT_GT(one.points[i].x(), one.points[i - 1].x());
  for (const auto& p : one.points) ASSERT_EQ(p.y(), 0.25 * p.x());
  Points visited;
  scan.forEachBlock([&](const Points& block) {
    for (const auto& p : block) visited.push_back(p + scan.origin());
  });
  EXPECT_EQ(visited, one.points);
}

TEST(TextColumns, EveryNthRowOfEachChunk) {
  const pcd_files::Folder folder;
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += std::to_string(i) + " 2 " + (i % 10 == 3 ? "nan" : "3") + "\n";
  const Scan scan = Scan::open({folder.file("a.txt", text)});
  const auto pass = passOf(scan, 2, 7);
  EXPECT_EQ(pass.counts.points, 100'000U);
  EXPECT_EQ(pass.counts.invalid, 10'000U);
  EXPECT_NEAR(static_cast<double>(pass.points.size()), 90'000.0 / 7.0, 10.0);
  EXPECT_EQ(pass.points[1].x() - pass.points[0].x(), 7.0);
}

TEST(TextColumns, LinesOnTheEdgesOfChunks) {
  const pcd_files::Folder folder;
  for (std::size_t pad = 0; pad < 14; ++pad) {  // a row has 14 bytes: every place of it meets the edge
    std::string text = "1 2 3" + std::string(pad, ' ') + "\n";
    while (text.size() < 1'100'000) text += "1111 222 3333\n";
    const Scan scan = Scan::open({folder.file("a.txt", text)});
    const auto pass = passOf(scan);
    const std::uint64_t rows = 1 + (text.size() - 6 - pad) / 14;
    EXPECT_EQ(scan.size(), rows) << pad;
    ASSERT_EQ(pass.points.size(), rows) << pad;
    EXPECT_EQ(pass.points.front(), Eigen::Vector3d(1, 2, 3));
    for (std::size_t i = 1; i < rows; ++i) ASSERT_EQ(pass.points[i], Eigen::Vector3d(1111, 222, 3333));
  }
}

TEST(TextColumns, ErrorsNameTheLineOfTheFile) {
  std::string text = "# c\r\n\r\nx y z\n";
  for (int i = 0; i < 60'000; ++i) text += "123456.789 2.5 3.5\n";
  text += "1 2 q\n";
  expectRefusal(text, "line 60004 of ");
}

TEST(TextColumns, CutAnywhereOrWithAnyByteChanged) {
  const std::string good = "name,x,y,z\n\"a\",1.5,2,3e1\nb,nan,5,6\n";
  for (std::size_t at = 0; at < good.size(); ++at) {
    read_scans::readHostile(good.substr(0, at));
    for (const char byte : {'\0', '\n', ',', '"', ' ', '9', '\xff'}) {
      std::string bytes = good;
      bytes[at] = byte;
      read_scans::readHostile(bytes);
    }
  }
}

}  // namespace tank_datum::text_columns_test
