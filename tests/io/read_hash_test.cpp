#include "io/read_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "io/input_file.h"
#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::read_hash_test {

using pcd_files::Folder;

constexpr const char* kOfNothing = "99aa06d3014798d86001c324468d497f";  // as xxhsum -H2 prints them
constexpr const char* kOfAbc = "06b05ab6733a618578af5f94892f3950";

std::string hashOf(std::string_view bytes) {
  ReadHash hash;
  hash.take(0, bytes);
  return hash.digest();
}

TEST(ReadHash, KnownAnswers) {
  EXPECT_EQ(hashOf(""), kOfNothing);
  EXPECT_EQ(hashOf("abc"), kOfAbc);
}

TEST(ReadHash, PiecesInAnyOrderSomeTwice) {
  ReadHash hash;
  hash.take(2, "c");
  hash.take(1, "b");
  EXPECT_EQ(hash.taken(), 0U);
  hash.take(0, "a");
  EXPECT_EQ(hash.taken(), 3U);
  hash.take(0, "ab");
  hash.take(1, "bc");
  EXPECT_EQ(hash.digest(), kOfAbc);
  ReadHash overlapping;
  overlapping.take(1, "bc");
  overlapping.take(0, "ab");
  EXPECT_EQ(overlapping.digest(), kOfAbc);
}

TEST(ReadHash, ShuffledPiecesGiveTheHashOfTheWhole) {
  std::string bytes(100'000, '\0');
  std::mt19937 random(1);
  std::generate(bytes.begin(), bytes.end(), [&random] { return static_cast<char>(random()); });
  std::vector<std::size_t> begins;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 777) begins.push_back(begin);
  std::shuffle(begins.begin(), begins.end(), random);
  ReadHash hash;
  for (const std::size_t begin : begins) hash.take(begin, std::string_view(bytes).substr(begin, 1000));
  EXPECT_EQ(hash.taken(), bytes.size());
  EXPECT_EQ(hash.digest(), hashOf(bytes));
}

TEST(ReadHash, KeepsLittleOfWhatComesEarly) {
  const std::string piece(std::size_t{40} << 20, 'x');
  ReadHash hash;
  hash.take(piece.size(), piece);
  hash.take(2 * piece.size(), piece);  // more than is kept
  hash.take(0, piece);
  EXPECT_EQ(hash.taken(), 2 * piece.size());
}

TEST(InputFile, HashIsThatOfTheBytesWhateverWasReadBefore) {
  const Folder folder;
  const std::string path = folder.file("abc", "abc");
  for (const bool hashed : {false, true}) {
    const InputFile file(path, hashed);
    char byte = 0;
    file.read(1, &byte, 1);
    EXPECT_EQ(file.xxh3(), kOfAbc);
    EXPECT_EQ(file.xxh3(), kOfAbc);
  }
  EXPECT_EQ(InputFile(folder.file("empty", "")).xxh3(), kOfNothing);
  EXPECT_EQ(InputFile(path).xxh3([] { return false; }), "");
}

/// A pass over the scan takes the hash: what stands in the file afterwards is not read any more.
TEST(Scan, HashIsTakenFromWhatAPassReads) {
  const Folder folder;
  std::vector<pcd_files::Row> rows;
  for (int i = 0; i < 100'000; ++i) rows.push_back({0.001 * i, 2, 3});
  for (const std::string encoding : {"binary", "ascii"}) {
    const std::string bytes = pcd_files::pcd(pcd_files::kXyzFloat, rows, encoding);
    const std::string path = folder.file("a.pcd", bytes);
    ScanOptions options;
    options.hash = true;
    const Scan scan = Scan::open({path}, 1.0, options);
    for (const int threads : {1, 2}) EXPECT_EQ(scan.everyNth(3, threads).size(), scan.everyNth(3, 1).size());
    std::string other = bytes;
    other.back() = static_cast<char>(other.back() ^ 1);
    folder.file("a.pcd", other);
    EXPECT_EQ(scan.hashOf(0), hashOf(bytes)) << encoding;
    EXPECT_EQ(Scan::open({path}).hashOf(0), hashOf(other)) << encoding;
  }
}

}  // namespace tank_datum::read_hash_test
