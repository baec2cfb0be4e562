#include "io/las_header.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "core/plain_text.h"
#include "io/input_file.h"
#include "io/io_error.h"
#include "io/las_rows.h"

namespace tank_datum {
namespace {

constexpr std::size_t kShortestHeader = 227;  // bytes, of versions 1.0 to 1.2
constexpr std::size_t kHeader14 = 375;        // of version 1.4

/// The header's bytes, little-endian as this machine is.
class LasBytes {
 public:
  explicit LasBytes(const InputFile& file) : file_(file), bytes_(std::min<std::uint64_t>(kHeader14, file.size())) {
    file.read(0, bytes_.data(), bytes_.size());
    require(kShortestHeader);
  }

  /// @throws Error (File) when the file has fewer bytes
  void require(std::size_t bytes) const {
    if (bytes_.size() >= bytes) return;
    throw fileError("LAS header", file_.path(), std::to_string(bytes_.size()) + " bytes",
                    "at least " + std::to_string(bytes));
  }

  template <typename T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, bytes_.data() + offset, sizeof(T));
    return value;
  }

 private:
  const InputFile& file_;
  std::vector<char> bytes_;
};

struct LasFacts {
  unsigned minor = 0;  ///< of version 1.minor
  unsigned header_bytes = 0;
  std::uint64_t data_offset = 0;
  LasStorage stored;
  std::uint64_t points = 0;
};

void checkVersion(const InputFile& file, const LasBytes& bytes, LasFacts& facts) {
  const unsigned major = bytes.at<std::uint8_t>(24);
  facts.minor = bytes.at<std::uint8_t>(25);
  if (major != 1 || facts.minor > 4) {
    throw fileError("LAS version", file.path(), std::to_string(major) + "." + std::to_string(facts.minor),
                    "1.0 to 1.4");
  }
}

void checkFormat(const InputFile& file, const LasBytes& bytes, LasFacts& facts) {
  facts.stored.format = bytes.at<std::uint8_t>(104);
  if (facts.stored.format >= kLasPointBytes.size()) {
    throw fileError("LAS point format", file.path(), std::to_string(facts.stored.format), "0 to 10");
  }
  facts.stored.row_bytes = bytes.at<std::uint16_t>(105);
  if (facts.stored.row_bytes < kLasPointBytes[facts.stored.format]) {
    throw fileError("LAS point length", file.path(), std::to_string(facts.stored.row_bytes) + " bytes",
                    "at least " + std::to_string(kLasPointBytes[facts.stored.format]) + " of point format " +
                        std::to_string(facts.stored.format));
  }
}

void checkPlace(const InputFile& file, const LasBytes& bytes, LasFacts& facts) {
  const std::size_t shortest = facts.minor == 4 ? kHeader14 : kShortestHeader;
  bytes.require(shortest);
  facts.header_bytes = bytes.at<std::uint16_t>(94);
  if (facts.header_bytes < shortest) {
    throw fileError("LAS header size", file.path(), std::to_string(facts.header_bytes) + " bytes",
                    "at least " + std::to_string(shortest) + " of version 1." + std::to_string(facts.minor));
  }
  facts.data_offset = bytes.at<std::uint32_t>(96);
  if (facts.data_offset < facts.header_bytes || facts.data_offset > file.size()) {
    throw fileError("LAS offset to the points", file.path(), std::to_string(facts.data_offset),
                    "at least " + std::to_string(facts.header_bytes) + " and at most " + std::to_string(file.size()) +
                        ", the bytes in the file");
  }
}

void checkPoints(const InputFile& file, const LasBytes& bytes, LasFacts& facts) {
  if (facts.minor == 4) facts.points = bytes.at<std::uint64_t>(247);
  if (facts.points == 0) facts.points = bytes.at<std::uint32_t>(107);
  const std::uint64_t most = (file.size() - facts.data_offset) / facts.stored.row_bytes;
  if (facts.points > most) {
    throw fileError("points", file.path(), std::to_string(facts.points) + " in the header",
                    "at most " + std::to_string(most) + ", all that " + std::to_string(file.size()) + " bytes hold");
  }
}

void checkScale(const InputFile& file, const LasBytes& bytes, std::size_t axis, LasStorage& stored) {
  constexpr double kLargest = 0x1p31;  // of what is stored
  const double scale = bytes.at<double>(131 + 8 * axis), shift = bytes.at<double>(155 + 8 * axis);
  const std::string name(1, "xyz"[axis]);
  if (!(scale > 0.0) || !std::isfinite(kLargest * scale)) {
    throw fileError("LAS scale of " + name, file.path(), fixedText(scale), "a number > 0, such as 0.001");
  }
  if (!std::isfinite(shift) || !std::isfinite(std::abs(shift) + kLargest * scale)) {
    throw fileError("LAS offset of " + name, file.path(), fixedText(shift), "a number");
  }
  stored.scales[axis] = scale;
  stored.shifts[axis] = shift;
}

}  // namespace

RecordRows readLasHeader(const InputFile& file, const std::vector<int>& classes) {
  const LasBytes bytes(file);
  LasFacts facts;
  checkVersion(file, bytes, facts);
  checkFormat(file, bytes, facts);
  checkPlace(file, bytes, facts);
  checkPoints(file, bytes, facts);
  for (std::size_t axis = 0; axis < 3; ++axis) checkScale(file, bytes, axis, facts.stored);
  RecordRows records = lasRows(facts.stored, classes);
  records.offset = facts.data_offset;
  records.rows = facts.points;
  return records;
}

}  // namespace tank_datum
