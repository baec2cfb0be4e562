// Data that are not what the header says, and the odd but valid: found while reading, not while opening.

#include "io/pcd_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::pcd_data_test {

using pcd_files::errorOf;
using pcd_files::Folder;

Points pointsOf(const std::string& path, double metres_per_unit = 1.0) {
  Points points;
  const Scan scan = Scan::open({path}, metres_per_unit);
  scan.forEachBlock([&](const Points& block) {
    for (const Eigen::Vector3d& p : block) points.push_back(p + scan.origin());
  });
  return points;
}

Points asciiPoints(std::size_t points, const std::string& data) {
  const Folder folder;
  return pointsOf(folder.file("a.pcd", pcd_files::header(pcd_files::kXyzFloat, points, "ascii") + data));
}

void expectRefusal(std::size_t points, const std::string& data, const std::string& part) {
  const std::string message = errorOf([&] { asciiPoints(points, data); });
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_NE(message.find("a.pcd"), std::string::npos) << message;
}

TEST(PcdAscii, SpellingsThatAreRead) {
  const Points points = asciiPoints(5, "1 2 3\r\n\n  \t+4\t-5.5 \t6e1 \n1,2 , 3\n.5, 1., 25E-2\n-0 0 0");
  const Points expected = {{1, 2, 3}, {4, -5.5, 60}, {1, 2, 3}, {0.5, 1, 0.25}, {0, 0, 0}};
  EXPECT_EQ(points, expected);
  EXPECT_EQ(asciiPoints(1, "289814.15,4320978.61,170.76\n\n \n"), (Points{{289814.15, 4320978.61, 170.76}}));
}

TEST(PcdAscii, NotFiniteInAnyCase) {
  EXPECT_EQ(asciiPoints(6, "nan 0 0\n0 NaN 0\n0 0 NAN\n-nan 0 0\ninf 0 -Inf\n1 2 3\n"), (Points{{1, 2, 3}}));
}

TEST(PcdAscii, NotFiniteAsWindowsWroteIt) {
  EXPECT_EQ(asciiPoints(6, "-1.#IND 0 0\n0 1.#QNAN 0\n0 0 1.#INF\n-1.#IND00 0 0\n0 +1.#SNAN 0\n1 2 3\n"),
            (Points{{1, 2, 3}}));
  for (const std::string word : {"1.#", "1.#IN", "2.#IND", "1.#INDX", "1.#INF1", "#IND"}) {
    expectRefusal(1, "1 2 " + word + "\n", "\"" + word + "\"");
  }
}

TEST(PcdAscii, CommentsBetweenRows) {
  EXPECT_EQ(asciiPoints(2, "# from here\n1 2 3\n \t#4 5 6\n\n#\n7 8 9\n# the end\n"), (Points{{1, 2, 3}, {7, 8, 9}}));
  expectRefusal(2, "1.5 2.5 3.5\n# 4 5 6\n", "1 whole ones, expected 2 (POINTS)");
}

TEST(PcdAscii, BytesBehindTheLastRowArePassedOver) {
  const std::string page(4096, '\0');
  EXPECT_EQ(asciiPoints(1, "1 2 3\n" + page), (Points{{1, 2, 3}}));
  EXPECT_EQ(asciiPoints(1, "1 2 3\n\x1a"), (Points{{1, 2, 3}}));  // the end of a file under DOS
}

TEST(PcdAscii, WhatIsNoNumber) {
  expectRefusal(2, "1 2 3\n4 abc 6\n", "row 2 of ");
  expectRefusal(2, "1 2 3\n4 abc 6\n", "\"abc\", expected a number");
  for (const std::string word : {"1.5x", "0x10", "1-2", "--1", "+-1", "1;2", "1e999", "#", "1_0", "e5", "+"}) {
    expectRefusal(1, "1 2 " + word + "\n", "\"" + word + "\"");
  }
  expectRefusal(1, "1,,2,3\n", "\",2\"");
  expectRefusal(1, ",1,2,3\n", "row 1 of ");
  expectRefusal(1, std::string("1 2 \0\x1b\n", 7), "\"??\"");
}

TEST(PcdAscii, RowsOfAnotherLength) {
  expectRefusal(2, "1.5 2.5 3.5\n4 5\n", "2 values, expected 3");
  expectRefusal(1, "1 2 3 4\n", "more values, expected 3");
  expectRefusal(1, "1 2 3,\n", "more values, expected 3");
  expectRefusal(1, "1000,5 2000,5 30,5\n", "more values, expected 3");  // decimal commas: never wrong numbers
}

TEST(PcdAscii, FewerAndMoreRowsThanPoints) {
  expectRefusal(3, "1.25 2.25 3.25\n4.25 5.25 6.25\n", "2 whole ones, expected 3 (POINTS)");
  expectRefusal(3, "1.25 2.25 3.25\n4.25 5.25 6.25\n7.25 8.25", "2 whole ones, expected 3 (POINTS)");
  expectRefusal(1, "1 2 3\n4", "more than POINTS");
  expectRefusal(1, "1 2 3\n4 5 6\n", "more than POINTS, expected 1 (POINTS)");
}

TEST(PcdAscii, LinesOfAnyLength) {
  const std::string spaces(3000000, ' ');
  EXPECT_EQ(asciiPoints(2, "1 2" + spaces + "3\n4 5 6\n"), (Points{{1, 2, 3}, {4, 5, 6}}));
  expectRefusal(1, "1 2 " + spaces + spaces + "3\n", "above 4194304 bytes");
}

TEST(PcdBinary, CutShortAfterOpening) {
  const Folder folder;
  const std::vector<pcd_files::Row> rows(50000, {1, 2, 3});
  for (const std::string data : {"ascii", "binary", "binary_compressed"}) {
    const std::string path = folder.file(data, pcd_files::pcd(pcd_files::kXyzFloat, rows, data));
    const Scan scan = Scan::open({path});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    EXPECT_NE(errorOf([&] { scan.forEachBlock([](const Points&) {}); }).find(path), std::string::npos);
  }
}

TEST(PcdBinary, BlocksCanBeDecodedInAnyOrder) {
  const Folder folder;
  std::vector<pcd_files::Row> rows;
  for (int i = 0; i < 40000; ++i) rows.push_back({1.0 * i, 2.0, i == 39999 ? std::nan("") : 3.0});
  const InputFile file(folder.file("a.pcd", pcd_files::pcd(pcd_files::kXyzFloat, rows, "binary")));
  const RecordRows records = recordRowsOf(readPcdHeader(file));
  ASSERT_EQ(recordBlockCount(records), 3U);
  const Frame frame{2.0, {10, 0, 0}};
  BlockBuffer buffer;
  EXPECT_EQ(decodeRecordBlock(file, records, frame, {2}, buffer).points, 40000U - 2 * kBlockRows);
  EXPECT_EQ(buffer.points.size(), 40000U - 2 * kBlockRows - 1);
  EXPECT_EQ(buffer.points.back(), Eigen::Vector3d(2 * 39998 - 10, 4, 6));
  EXPECT_EQ(decodeRecordBlock(file, records, frame, {0}, buffer).points, kBlockRows);
  EXPECT_EQ(buffer.points[1], Eigen::Vector3d(-8, 4, 6));
}

TEST(PcdBinary, ChosenRowsAreDecodedAndAllAreChecked) {
  const Folder folder;
  std::vector<pcd_files::Row> rows;
  for (int i = 0; i < 1000; ++i) rows.push_back({1.0 * i, 2.0, 3.0});
  rows[7][0] = std::nan(""), rows[8][1] = HUGE_VAL, rows[9][2] = -HUGE_VAL;
  BlockBuffer buffer;
  for (const auto& fields :
       {pcd_files::kXyzFloat, std::vector<pcd_files::Field>{{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}}}) {
    const InputFile file(folder.file("a.pcd", pcd_files::pcd(fields, rows, "binary")));
    const RecordRows records = recordRowsOf(readPcdHeader(file));
    for (const RowChoice choice : {RowChoice{0, 1}, RowChoice{2, 5}, RowChoice{4, 7}, RowChoice{999, 1001}}) {
      const ScanCounts counts = decodeRecordBlock(file, records, {}, {0, choice}, buffer);
      EXPECT_EQ(counts.points, 1000U);
      EXPECT_EQ(counts.invalid, 3U) << choice.step;
      Points expected;
      for (std::size_t i = choice.first; i < 1000; i += choice.step) {
        if (i < 7 || i > 9) expected.emplace_back(static_cast<double>(i), 2.0, 3.0);
      }
      EXPECT_EQ(buffer.points, expected) << choice.step;
    }
  }
}

TEST(PcdBinary, WideRows) {
  const Folder folder;
  const std::vector<pcd_files::Field> fields = {{"pad", 'U', 1, 65524}, {"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}};
  std::vector<pcd_files::Row> rows(3, pcd_files::Row(65527, 1.0));
  rows[2][65524] = 7;
  for (const std::string data : {"ascii", "binary", "binary_compressed"}) {
    const Points points = pointsOf(folder.file(data, pcd_files::pcd(fields, rows, data)));
    EXPECT_EQ(points, (Points{{1, 1, 1}, {1, 1, 1}, {7, 1, 1}}));
  }
  const std::string many = pcd_files::header(fields, 100, "binary") + std::string(100 * 65536, '\0');  // 2 blocks
  EXPECT_EQ(pointsOf(folder.file("many", many)).size(), 100U);
}

TEST(PcdCompressed, DamagedBlock) {
  const Folder folder;
  const std::vector<pcd_files::Row> rows(1000, {1, 2, 3});
  std::string bytes = pcd_files::pcd(pcd_files::kXyzFloat, rows, "binary_compressed");
  bytes[bytes.find("compressed\n") + 11 + 8] = '\xff';  // begins with a reference to what is not there
  const std::string message = errorOf([&] { pointsOf(folder.file("a.pcd", bytes)); });
  EXPECT_NE(message.find("compressed data of "), std::string::npos) << message;
}

/// A result or an Error; anything else, a crash or a hang fails the test.
void readHostile(const std::string& path) {
  try {
    std::size_t points = 0;
    const ScanCounts counts = Scan::open({path}).forEachBlock([&](const Points& block) { points += block.size(); });
    EXPECT_EQ(counts.points - counts.invalid, points);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::File);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

class Hostile : public testing::TestWithParam<std::string> {
 protected:
  Hostile() {
    std::vector<pcd_files::Row> rows;
    for (int i = 0; i < 40; ++i) rows.push_back({1.5 * i, -2.25, 3.0 + i % 2, 7.0});
    bytes_ = pcd_files::pcd({{"x", 'F', 4}, {"y", 'F', 8}, {"z", 'I', 2}, {"label", 'U', 1}}, rows, GetParam());
  }
  Folder folder_;
  std::string bytes_;
};
INSTANTIATE_TEST_SUITE_P(All, Hostile, testing::Values("ascii", "binary", "binary_compressed"),
                         pcd_files::nameOfEncoding);

TEST_P(Hostile, EveryTruncation) {
  for (std::size_t size = 0; size <= bytes_.size(); ++size) readHostile(folder_.file("a.pcd", bytes_.substr(0, size)));
}

TEST_P(Hostile, RandomBytes) {
  std::mt19937 random(20180605);
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = bytes_;
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    }
    readHostile(folder_.file("a.pcd", bytes));
  }
}

}  // namespace tank_datum::pcd_data_test
