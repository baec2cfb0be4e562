#include "io/e57_pages.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "core/parallel.h"
#include "io/input_file.h"

namespace tank_datum {
namespace {

constexpr std::size_t kPage = 1024, kSum = 4;  // bytes, and of them the checksum's

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

/// Of a byte that is followed by so many others of the same eight ("slicing by eight", Kounavis and Berry 2005).
constexpr Tables makeTables() {
  constexpr std::uint32_t kPolynomial = 0x82f63b78;  // Castagnoli's, bits reversed
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1U) * kPolynomial);
    tables[0][byte] = rest;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xff];
    }
  }
  return tables;
}

constexpr Tables kTables = makeTables();

bool isSound(const unsigned char* page) {
  std::uint32_t told = 0;
  for (std::size_t i = kPage - kSum; i < kPage; ++i) told = (told << 8) | page[i];
  return crc32c(page, kPage - kSum) == told;
}

}  // namespace

std::uint32_t crc32c(const unsigned char* bytes, std::size_t count) {
  std::uint32_t rest = ~std::uint32_t{0};
  for (; count >= 8; count -= 8, bytes += 8) {
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint32_t with = k < 4 ? (rest >> (8 * k)) & 0xff : 0;
      next ^= kTables[7 - k][bytes[k] ^ with];
    }
    rest = next;
  }
  for (; count > 0; --count, ++bytes) rest = (rest >> 8) ^ kTables[0][(rest ^ *bytes) & 0xff];
  return ~rest;
}

bool e57PagesAreSound(const std::string& path, const PageRange& pages, int threads) {
  constexpr std::uint64_t kAtOnce = 1024;  // pages
  const InputFile file(path);
  const std::uint64_t in_file = (file.size() + kPage - 1) / kPage;
  const std::uint64_t first = std::min(in_file, pages.first);
  const std::uint64_t behind = first + std::min(in_file - first, pages.count);
  std::atomic<bool> sound{true};
  forEachIndex(static_cast<std::size_t>((behind - first + kAtOnce - 1) / kAtOnce), threads, [&](std::size_t part) {
    if (!sound) return;
    const std::uint64_t begin = first + part * kAtOnce;
    std::vector<unsigned char> bytes(static_cast<std::size_t>(std::min(kAtOnce, behind - begin)) * kPage);
    const std::size_t got = file.readSome(begin * kPage, bytes.data(), bytes.size());
    bool all = got == bytes.size();
    for (std::size_t at = 0; all && at < got; at += kPage) all = isSound(bytes.data() + at);
    if (!all) sound = false;
  });
  return sound;
}

}  // namespace tank_datum
