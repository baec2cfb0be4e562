#include <gtest/gtest.h>

#include "io/io_error.h"
#include "io/pcd_header.h"
#include "io/pcd_writer.h"
#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::file_bounds_test {

using pcd_files::errorOf;
using pcd_files::Folder;

/// The rows of an ascii file of one row whose line is filled up with blanks to so many bytes.
void readRowOf(std::size_t bytes) {
  const Folder folder;
  std::string row = "1 2 3";
  row.resize(bytes, ' ');
  const std::string path = folder.file("a.pcd", pcd_files::header(pcd_files::kXyzFloat, 1, "ascii") + row + "\n");
  Scan::open({path}).forEachBlock([](const Points& block) { EXPECT_EQ(block.size(), 1U); });
}

TEST(FileBounds, ALineOfFourMebibytesIsNoRowOfNumbers) {
  readRowOf(3'500'000);
  EXPECT_NE(errorOf([] { readRowOf(5'000'000); }).find("a line of "), std::string::npos);
}

/// A compressed file of so many rows of 12 bytes in three bytes.
void readPackedRows(std::size_t rows) {
  const Folder folder;
  const std::string sizes =
      pcd_files::bytesOf<std::uint32_t>(3) + pcd_files::bytesOf<std::uint32_t>(12.0 * static_cast<double>(rows));
  readPcdHeader(folder.file(
      "a.pcd", pcd_files::header(pcd_files::kXyzFloat, rows, "binary_compressed") + sizes + std::string(3, '\0')));
}

TEST(FileBounds, LzfMakesAtMost264BytesOfThree) {
  readPackedRows(22);
  EXPECT_NE(errorOf([] { readPackedRows(23); }).find("POINTS of "), std::string::npos);
}

TEST(FileBounds, ARowHasAtMost64Kibibytes) {
  const Folder folder;
  const auto read = [&](int filling) {
    std::vector<pcd_files::Field> fields = pcd_files::kXyzFloat;
    fields.push_back({"_", 'U', 1, filling});
    readPcdHeader(folder.file("a.pcd", pcd_files::header(fields, 0, "binary")));
  };
  read(65'536 - 12);
  EXPECT_NE(errorOf([&] { read(65'536 - 11); }).find("COUNT of field _"), std::string::npos);
}

TEST(FileBounds, AWrittenCountHasRoomForTheLargestThereIs) {
  const Folder folder;
  PcdWriter writer(folder.path("a.pcd"), {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}});
  writer.append({1, 2, 3});
  writer.commit();
  const std::string text = pcd_files::readAll(folder.path("a.pcd"));
  const std::size_t digits = std::to_string(std::numeric_limits<std::uint64_t>::max()).size();
  EXPECT_NE(text.find("WIDTH 1" + std::string(digits - 1, ' ') + "\n"), std::string::npos);
  EXPECT_NE(text.find("POINTS 1" + std::string(digits - 1, ' ') + "\n"), std::string::npos);
}

TEST(FileBounds, FortyLettersOfAValueAreEchoed) {
  EXPECT_EQ(echo(std::string(40, 'a')), std::string(40, 'a'));
  EXPECT_EQ(echo(std::string(41, 'a')), std::string(40, 'a') + "...");
}

}  // namespace tank_datum::file_bounds_test
