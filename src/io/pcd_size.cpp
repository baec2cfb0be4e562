#include "io/pcd_size.h"

#include <array>

#include "io/io_error.h"

namespace tank_datum {
namespace {

void checkAtMost(std::uint64_t most, const InputFile& file, const PcdHeader& header) {
  if (header.points <= most) return;
  throw fileError("POINTS", file.path(), std::to_string(header.points),
                  "at most " + std::to_string(most) + ", all that " + std::to_string(file.size()) + " bytes can hold");
}

/// An ascii value needs a digit and a separator, which the very last may lack.
void checkAscii(std::uint64_t data_bytes, const InputFile& file, const PcdHeader& header) {
  checkAtMost((data_bytes + 1) / (2 * header.row_values), file, header);
}

void checkCompressed(std::uint64_t data_bytes, const InputFile& file, PcdHeader& header) {
  constexpr std::uint64_t kLzfBest = 88;  // LZF makes at most 264 bytes of 3
  if (header.points == 0) return;         // the sizes may be missing then
  std::array<std::uint32_t, 2> sizes{};   // compressed, uncompressed
  if (data_bytes < sizeof(sizes)) {
    throw fileError("compressed data", file.path(), std::to_string(data_bytes) + " bytes", "at least 8");
  }
  checkAtMost((data_bytes - sizeof(sizes)) * kLzfBest / header.row_bytes, file, header);
  file.read(header.data_offset, sizes.data(), sizeof(sizes));
  if (sizes[1] != header.points * header.row_bytes) {
    throw fileError("uncompressed size", file.path(), std::to_string(sizes[1]),
                    std::to_string(header.points * header.row_bytes) + " (POINTS rows of " +
                        std::to_string(header.row_bytes) + " bytes)");
  }
  if (sizes[0] > data_bytes - sizeof(sizes) || sizes[1] > sizes[0] * kLzfBest) {
    throw fileError("compressed size", file.path(), std::to_string(sizes[0]),
                    "at least " + std::to_string((sizes[1] + kLzfBest - 1) / kLzfBest) + " and at most " +
                        std::to_string(data_bytes - sizeof(sizes)) + ", the bytes in the file");
  }
  header.compressed_bytes = sizes[0];
}

}  // namespace

void checkPcdSize(const InputFile& file, PcdHeader& header) {
  const std::uint64_t data_bytes = file.size() - header.data_offset;
  switch (header.encoding) {
    case PcdEncoding::Ascii:
      return checkAscii(data_bytes, file, header);
    case PcdEncoding::Binary:
      return checkAtMost(data_bytes / header.row_bytes, file, header);
    case PcdEncoding::BinaryCompressed:
      return checkCompressed(data_bytes, file, header);
  }
}

}  // namespace tank_datum
