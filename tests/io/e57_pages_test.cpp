#include "io/e57_pages.h"

#include <gtest/gtest.h>

#include "support/pcd_files.h"

namespace tank_datum::e57_pages_test {

std::uint32_t sumOf(const std::string& text) {
  return crc32c(reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

/// Pages of an E57 file, each with its checksum.
std::string pagesOf(std::size_t count) {
  std::string file;
  for (std::size_t page = 0; page < count; ++page) {
    std::string bytes;
    for (std::size_t i = 0; i < 1020; ++i) bytes += static_cast<char>(page * 7 + i * i);
    const std::uint32_t sum = sumOf(bytes);
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((sum >> shift) & 0xff);
    file += bytes;
  }
  return file;
}

TEST(Crc32c, KnownAnswers) {  // RFC 3720, B.4
  EXPECT_EQ(sumOf(""), 0x00000000U);
  EXPECT_EQ(sumOf("123456789"), 0xe3069283U);
  EXPECT_EQ(sumOf(std::string(32, '\0')), 0x8a9136aaU);
  EXPECT_EQ(sumOf(std::string(32, '\xff')), 0x62a8ab43U);
  std::string rising, falling;
  for (int i = 0; i < 32; ++i) rising += static_cast<char>(i), falling += static_cast<char>(31 - i);
  EXPECT_EQ(sumOf(rising), 0x46dd794eU);
  EXPECT_EQ(sumOf(falling), 0x113fdb5cU);
}

TEST(E57Pages, OneBitThatIsWrongShowsInItsPage) {
  const pcd_files::Folder folder;
  const std::string whole = pagesOf(2500);
  const std::string path = folder.file("whole", whole);
  EXPECT_TRUE(e57PagesAreSound(path, {0, 2500}));
  EXPECT_TRUE(e57PagesAreSound(path, {0, std::uint64_t{1} << 62}));
  EXPECT_TRUE(e57PagesAreSound(path, {1'000'000, 10}));
  for (const std::size_t byte : {0UL, 1024UL * 1100 + 1019, 1024UL * 1100 + 1020, 1024UL * 2500 - 1}) {
    std::string broken = whole;
    broken[byte] = static_cast<char>(broken[byte] ^ 0x10);
    const std::string other = folder.file("broken", broken);
    const std::uint64_t page = byte / 1024;
    EXPECT_FALSE(e57PagesAreSound(other, {0, 2500})) << byte;
    EXPECT_FALSE(e57PagesAreSound(other, {page, 1})) << byte;
    EXPECT_TRUE(e57PagesAreSound(other, {page + 1, 2500})) << byte;
    EXPECT_TRUE(e57PagesAreSound(other, {0, page})) << byte;
  }
}

TEST(E57Pages, APageThatIsCutShortIsNone) {
  const pcd_files::Folder folder;
  EXPECT_FALSE(e57PagesAreSound(folder.file("short", pagesOf(3).substr(0, 3 * 1024 - 1)), {0, 3}));
  EXPECT_FALSE(e57PagesAreSound(folder.file("short", pagesOf(3).substr(0, 2 * 1024 + 1)), {0, 3}));
  EXPECT_TRUE(e57PagesAreSound(folder.file("empty", ""), {0, 3}));
  EXPECT_NE(pcd_files::errorOf([&] {
              e57PagesAreSound(folder.path("none"), {0, 1});
            }).find("No such file"),
            std::string::npos);
}

}  // namespace tank_datum::e57_pages_test
