#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace tank_datum {

/// CRC-32C (Castagnoli) of bytes, as RFC 3720 has it.
std::uint32_t crc32c(const unsigned char* bytes, std::size_t count);

/// Some pages of a file.
struct PageRange {
  std::uint64_t first = 0, count = 0;
};

/// Whether some pages of an E57 file hold the checksums of their bytes (ASTM E2807: pages of 1024 bytes, the last four
/// of them the CRC-32C of the others). Pages beyond the end of the file are sound, one that is cut short is not.
/// @param threads  0: all cores
/// @throws Error (File) when the file cannot be read
bool e57PagesAreSound(const std::string& path, const PageRange& pages, int threads = 0);

}  // namespace tank_datum
