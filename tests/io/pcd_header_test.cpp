#include "io/pcd_header.h"

#include <gtest/gtest.h>

#include "support/pcd_files.h"

namespace tank_datum::pcd_header_test {

using pcd_files::errorOf;
using pcd_files::Folder;

const std::string kOneRow = "1 2 3\n";

PcdHeader parse(const std::string& bytes) {
  const Folder folder;
  return readPcdHeader(folder.file("a.pcd", bytes));
}

std::string refusal(const std::string& bytes) {
  return errorOf([&] { parse(bytes); });
}

/// A header of one ascii row, with one line exchanged (or left out, or something put before it).
std::string with(const std::string& line, const std::string& instead) {
  std::string text = pcd_files::header(pcd_files::kXyzFloat, 1, "ascii") + kOneRow;
  const std::size_t at = text.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  return text.replace(at, line.size(), instead);
}

void expectRefusal(const std::string& bytes, const std::string& part) {
  const std::string message = refusal(bytes);
  EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_NE(message.find("a.pcd"), std::string::npos) << message;
}

TEST(PcdHeader, OffsetsOfFields) {
  const std::vector<pcd_files::Field> fields = {
      {"label", 'U', 1}, {"histogram", 'F', 4, 33}, {"z", 'F', 8}, {"_", 'U', 1, 3}, {"y", 'I', 2}, {"x", 'F', 4}};
  const std::string text = pcd_files::header(fields, 2, "binary");
  const PcdHeader header = parse(text + std::string(2 * 150, '\0'));
  EXPECT_EQ(header.row_bytes, 150U);
  EXPECT_EQ(header.row_values, 40U);
  EXPECT_EQ(header.points, 2U);
  EXPECT_EQ(header.data_offset, text.size());
  EXPECT_EQ(header.encoding, PcdEncoding::Binary);
  EXPECT_EQ(header.xyz, (std::array<std::size_t, 3>{5, 4, 2}));
  EXPECT_EQ(header.columns[2].offset, 133U);
  EXPECT_EQ(header.columns[2].first_value, 34U);
  EXPECT_EQ(header.columns[5].offset, 146U);
  EXPECT_EQ(header.columns[5].first_value, 39U);
}

TEST(PcdHeader, VersionsKnownAndNot) {
  for (const std::string version : {"0.7", ".7", "v.7", "v0.7", ".5", "0.6"}) {
    EXPECT_EQ(parse(with("VERSION 0.7", "VERSION " + version)).points, 1U) << version;
  }
  EXPECT_EQ(parse(with("VERSION 0.7\n", "")).points, 1U);
  expectRefusal(with("VERSION 0.7", "VERSION 0.8"), "VERSION of ");
  expectRefusal(with("VERSION 0.7", "VERSION"), "0 values, expected one");
}

TEST(PcdHeader, AnyOrderCommentsBlankLinesAndLineEnds) {
  std::string text =
      "# comment\r\n\r\nPOINTS 1\r\n  HEIGHT\t1\r\nTYPE F F F\r\n#\r\nWIDTH 1\r\nCOUNT 1 1 1\r\nSIZE 4 4 4\r\n"
      "FIELDS x y z  \r\nDATA ascii\r\n";
  EXPECT_EQ(parse(text + "1 2 3\r\n").data_offset, text.size());
  EXPECT_EQ(parse(with("FIELDS", "COLUMNS")).points, 1U);  // as version 0.5 called it
}

TEST(PcdHeader, WhatMayBeMissing) {
  EXPECT_EQ(parse(with("COUNT 1 1 1\n", "")).row_values, 3U);
  EXPECT_EQ(parse(with("WIDTH 1\n", "")).points, 1U);
  EXPECT_EQ(parse(with("HEIGHT 1\n", "")).points, 1U);
  EXPECT_EQ(parse(with("POINTS 1\n", "")).points, 1U);
  EXPECT_EQ(parse(with("VIEWPOINT 0 0 0 1 0 0 0\n", "")).points, 1U);
  EXPECT_EQ(parse(pcd_files::header(pcd_files::kXyzFloat, 0, "binary")).points, 0U);
  EXPECT_EQ(parse(pcd_files::header(pcd_files::kXyzFloat, 0, "binary_compressed")).points, 0U);
  expectRefusal(with("WIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\n", ""), "expected a line POINTS or WIDTH");
}

TEST(PcdHeader, WhatMustBeThere) {
  expectRefusal(with("FIELDS x y z\n", ""), "FIELDS of ");
  expectRefusal(with("SIZE 4 4 4\n", ""), "SIZE of ");
  expectRefusal(with("TYPE F F F\n", ""), "missing, expected a line TYPE");
  expectRefusal(with("DATA ascii\n", ""), "header line 11 of ");
  expectRefusal(with("DATA ascii\n1 2 3\n", ""), "no DATA line");
}

TEST(PcdHeader, UpperCaseAxesAndBoth) {
  EXPECT_EQ(parse(with("FIELDS x y z", "FIELDS X Y Z")).xyz, (std::array<std::size_t, 3>{0, 1, 2}));
  const std::vector<pcd_files::Field> both = {{"X", 'F', 4}, {"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}};
  EXPECT_EQ(parse(pcd_files::pcd(both, {{9, 1, 2, 3}}, "ascii")).xyz, (std::array<std::size_t, 3>{1, 2, 3}));
}

TEST(PcdHeader, AxesMissingTwiceOrWide) {
  expectRefusal(with("FIELDS x y z", "FIELDS x y intensity"), "no z, expected x, y and z");
  expectRefusal(with("FIELDS x y z", "FIELDS x y y"), "y twice");
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 2 1"), "COUNT of field y of ");
  expectRefusal(with("FIELDS x y z", "FIELDS"), "SIZE of ");
}

TEST(PcdHeader, TypesAndSizes) {
  for (const std::string size : {"2", "3", "0", "-4", "16", "4.0"}) {
    expectRefusal(with("SIZE 4 4 4", "SIZE 4 " + size + " 4"), "field y of ");
  }
  expectRefusal(with("TYPE F F F", "TYPE F F D"), "D 4, expected F of 4 or 8 bytes");
  expectRefusal(with("TYPE F F F", "TYPE F F"), "2 values, expected 3 as in FIELDS");
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 1 1 1"), "4 values, expected 3");
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 1.0 1"), "1.0, expected whole numbers");
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 1 9223372036854775807"), "65536 bytes");
}

TEST(PcdHeader, CountsThatAreNotOrDisagree) {
  expectRefusal(with("POINTS 1", "POINTS -5"), "-5, expected a whole number >= 0");
  expectRefusal(with("POINTS 1", "POINTS 1e6"), "1e6, expected a whole number");
  expectRefusal(with("POINTS 1", "POINTS 99999999999999999999"), "expected a whole number");
  expectRefusal(with("POINTS 1", "POINTS 1 2"), "2 values, expected one");
  expectRefusal(with("WIDTH 1", "WIDTH 2"), "2 x 1, expected 1 (POINTS)");
  expectRefusal(with("HEIGHT 1", "HEIGHT 0"), "1 x 0, expected 1 (POINTS)");
  expectRefusal(with("WIDTH 1\nHEIGHT 1", "WIDTH 4294967296\nHEIGHT 4294967296"), "WIDTH x HEIGHT of ");
  expectRefusal(with("DATA ascii", "DATA base64"), "base64, expected ascii, binary");
  expectRefusal(with("HEIGHT 1", "HEIGHT 1\nHEIGHT 1"), "a second line 9");
}

TEST(PcdHeader, MorePointsThanTheFileCanHold) {
  const auto& fields = pcd_files::kXyzFloat;
  expectRefusal(pcd_files::header(fields, 2, "ascii") + "1 2 3\n", "POINTS of ");
  EXPECT_EQ(parse(pcd_files::header(fields, 2, "ascii") + "1 2 3\n4 5 6").points, 2U);
  expectRefusal(pcd_files::header(fields, 2, "binary") + std::string(23, '\0'), "2, expected at most 1");
  for (const std::string data : {"ascii", "binary", "binary_compressed"}) {
    expectRefusal(pcd_files::header(fields, 1000000000000000000, data) + std::string(99, '\1'), "expected at most");
  }
}

TEST(PcdHeader, BytesBehindTheDataArePassedOver) {
  for (const std::string data : {"binary", "binary_compressed"}) {
    const std::string text = pcd_files::pcd(pcd_files::kXyzFloat, {{1, 2, 3}}, data);
    for (const std::size_t more : {11U, 12U, 4096U})
      EXPECT_EQ(parse(text + std::string(more, '\0')).points, 1U) << more;
  }
}

TEST(PcdHeader, FieldsOfCountZeroAreNotThere) {
  std::vector<pcd_files::Field> fields = {{"x", 'F', 4}, {"_", 'U', 1, 0}, {"y", 'F', 4}, {"z", 'F', 4}};
  for (const std::string data : {"ascii", "binary", "binary_compressed"}) {
    const PcdHeader header = parse(pcd_files::pcd(fields, {{1, 2, 3}}, data));
    EXPECT_EQ(header.row_bytes, 12U);
    EXPECT_EQ(header.row_values, 3U);
    EXPECT_EQ(header.xyz, (std::array<std::size_t, 3>{0, 1, 2}));
  }
  fields[1] = {"nothing", 'X', 0, 0};  // whose type and size mean nothing
  EXPECT_EQ(parse(pcd_files::pcd(fields, {{1, 2, 3}}, "binary")).row_bytes, 12U);
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 0 1"), "no y, expected x, y and z");
}

TEST(PcdHeader, NegativeCountsLeadBack) {
  const std::vector<pcd_files::Field> fields = {{"x", 'F', 4}, {"_", 'U', 1, 8}, {"rgb", 'U', 4}, {"_", 'U', 1, -12},
                                                {"y", 'F', 4}, {"z", 'F', 4},    {"_", 'U', 1, 4}};
  const std::string text = pcd_files::header(fields, 1, "binary");
  const PcdHeader header = parse(text + std::string(16, '\0'));
  EXPECT_EQ(header.row_bytes, 16U);
  ASSERT_EQ(header.columns.size(), 6U);
  EXPECT_EQ(header.columns[2].offset, 12U);  // rgb
  EXPECT_EQ(header.columns[header.xyz[1]].offset, 4U);
  EXPECT_EQ(header.columns[header.xyz[2]].offset, 8U);
  expectRefusal(text + std::string(15, '\0'), "expected at most 0");
  expectRefusal(with("COUNT 1 1 1", "COUNT 1 1 -3"), "no fewer than none");
  const std::vector<pcd_files::Field> cut = {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}, {"_", 'U', 1, -8}};
  expectRefusal(pcd_files::header(cut, 1, "binary") + std::string(99, '\0'), "ends before its field y");
}

TEST(PcdHeader, AnyCaseAndAByteOrderMark) {
  EXPECT_EQ(parse(with("DATA ascii", "DATA ASCII")).points, 1U);
  EXPECT_EQ(parse(with("DATA ascii", "data Ascii")).points, 1U);
  EXPECT_EQ(parse(with("FIELDS", "columns")).points, 1U);
  EXPECT_EQ(parse(with("TYPE F F F", "type f f F")).row_bytes, 12U);
  expectRefusal(with("HEIGHT 1", "HEIGHT 1\nheight 1"), "HEIGHT of ");
  const std::string mark = "\xef\xbb\xbf", text = with("VERSION 0.7", "version .7");
  EXPECT_EQ(parse(mark + text).data_offset, parse(text).data_offset + mark.size());
  EXPECT_EQ(parse(mark + text.substr(text.find('\n') + 1)).points, 1U);  // before a keyword, not a comment
  expectRefusal(mark.substr(0, 2) + text, "header line 1 of ");
}

TEST(PcdHeader, CompressedSizesThatLie) {
  const std::string head = pcd_files::header(pcd_files::kXyzFloat, 1, "binary_compressed");
  const auto sizes = [](double packed, double plain) {
    return pcd_files::bytesOf<std::uint32_t>(packed) + pcd_files::bytesOf<std::uint32_t>(plain);
  };
  expectRefusal(head, "0 bytes, expected at least 8");
  expectRefusal(head + sizes(14, 24) + std::string(14, '\0'), "24, expected 12 (POINTS rows of 12 bytes)");
  expectRefusal(head + sizes(15, 12) + std::string(14, '\0'), "15, expected at least 1 and at most 14");
  expectRefusal(head + sizes(0, 12) + std::string(14, '\0'), "compressed size of ");
}

TEST(PcdHeader, NotAPcdAtAll) {
  expectRefusal("", "an empty file");
  expectRefusal("289814.15 4320978.61 170.76\n", "header line 1 of ");
  expectRefusal(std::string(200, '\0'), "expected VERSION");
  expectRefusal(std::string(10000000, '#'), "no DATA line in 65536 bytes");
  expectRefusal(std::string(10000000, '\n'), "no DATA line");
  const std::string message = refusal("\x1b[31m\x07\xff" + std::string(5000, 'A') + "\n");
  EXPECT_LT(message.size(), 300U);
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_EQ(message.find('\xff'), std::string::npos);
}

TEST(PcdHeader, FilesThatCannotBeRead) {
  const Folder folder;
  EXPECT_NE(errorOf([&] { readPcdHeader(folder.path("none.pcd")); }).find("none.pcd, No such file"), std::string::npos);
  EXPECT_NE(errorOf([&] { readPcdHeader(folder.path("")); }).find("a folder"), std::string::npos);
  EXPECT_NE(errorOf([&] { readPcdHeader("/dev/zero"); }).find("not a regular file"), std::string::npos);
  EXPECT_NE(errorOf([&] { readPcdHeader(std::string("a\nb")); }).find("a?b"), std::string::npos);
}

}  // namespace tank_datum::pcd_header_test
