#include <cstring>
#include <optional>
#include <string_view>

#include "io/coordinates.h"
#include "io/io_error.h"
#include "io/pcd_data.h"
#include "io/text_number.h"

namespace tank_datum {
namespace {

/// Lines of a file, read in chunks.
class LineReader {
 public:
  LineReader(const InputFile& file, std::uint64_t offset) : file_(file), offset_(offset), buffer_(kChunk) {}

  /// The next line without its end, valid until the next call; nothing at the end of the file.
  std::optional<std::string_view> next() {
    while (true) {
      const char* begin = buffer_.data() + begin_;
      const auto* newline = static_cast<const char*>(std::memchr(begin, '\n', end_ - begin_));
      if (newline != nullptr) {
        begin_ += static_cast<std::size_t>(newline - begin) + 1;
        return std::string_view(begin, static_cast<std::size_t>(newline - begin));
      }
      if (refill()) continue;
      if (begin_ == end_) return std::nullopt;
      terminated_ = false;
      const std::string_view last(buffer_.data() + begin_, end_ - begin_);
      begin_ = end_;
      return last;
    }
  }

  /// Whether the last line had a line end; the file may have been cut in the middle of one that has not.
  bool terminated() const { return terminated_; }

 private:
  static constexpr std::size_t kChunk = std::size_t{1} << 20;
  static constexpr std::size_t kLongestLine = std::size_t{4} << 20;

  /// Moves the rest to the front and reads on behind it; false at the end of the file.
  bool refill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (end_ == kLongestLine) {
      throw fileError("a line", file_.path(), "above " + std::to_string(kLongestLine) + " bytes", "rows of numbers");
    }
    if (end_ == buffer_.size()) buffer_.resize(2 * end_);
    const std::size_t got = file_.readSome(offset_, buffer_.data() + end_, buffer_.size() - end_);
    offset_ += got;
    end_ += got;
    return got != 0;
  }

  const InputFile& file_;
  std::uint64_t offset_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // what is read and not yet handed out
  bool terminated_ = true;
};

Error rowError(const InputFile& file, std::uint64_t row, const std::string& value, const std::string& expected) {
  return fileError("row " + std::to_string(row), file.path(), value, expected);
}

/// The number at the beginning of [at, end), which blanks, a comma or the end must follow; else null.
const char* parseValue(const char* at, const char* end, double& value) {
  const char* stop = parseNumber(at, end, value);
  return stop != nullptr && (stop == end || isBlank(*stop) || *stop == ',') ? stop : nullptr;
}

/// Reads at most values.size() numbers; returns how many the line has, one more if there is something behind them.
std::size_t parseRow(std::string_view line, std::uint64_t row, const InputFile& file, std::vector<double>& values) {
  const char* end = line.data() + line.size();
  const char* at = skipBlanks(line.data(), end);
  if (at != end && *at == '#') return 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (at == end) return i;
    const char* stop = parseValue(at, end, values[i]);
    if (stop == nullptr) {
      const std::string_view rest(at, static_cast<std::size_t>(end - at));
      throw rowError(file, row, "\"" + echo(rest.substr(0, rest.find_first_of(" \t\r,", 1))) + "\"", "a number");
    }
    at = skipBlanks(stop, end);
    if (i + 1 < values.size() && at != end && *at == ',') at = skipBlanks(at + 1, end);
  }
  return values.size() + (at == end ? 0 : 1);
}

bool beginsWithNumber(std::string_view line) {
  const char* end = line.data() + line.size();
  double value = 0.0;
  return parseValue(skipBlanks(line.data(), end), end, value) != nullptr;
}

Error countError(const InputFile& file, const PcdHeader& header, const std::string& rows) {
  return fileError("rows", file.path(), rows, std::to_string(header.points) + " (POINTS)");
}

}  // namespace

ScanCounts visitAscii(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit) {
  LineReader lines(file, header.data_offset);
  std::vector<double> values(header.row_values);
  std::array<std::size_t, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = header.columns[header.xyz[axis]].first_value;
  const Eigen::Vector3d from(header.notes.origin.data());
  Points points;
  Labels labels;
  ScanCounts counts;
  while (const auto line = lines.next()) {
    if (counts.points == header.points) {
      if (beginsWithNumber(*line)) throw countError(file, header, "more than POINTS");
      continue;
    }
    const std::size_t found = parseRow(*line, counts.points + 1, file, values);
    if (found == 0) continue;
    if (found < values.size() && !lines.terminated()) break;  // the file ends within a row
    if (found != values.size()) {
      const std::string many = found < values.size() ? std::to_string(found) : "more";
      throw rowError(file, counts.points + 1, many + " values", std::to_string(values.size()));
    }
    ++counts.points;
    if (!appendFinite(from + Eigen::Vector3d(values[at[0]], values[at[1]], values[at[2]]), frame, points)) {
      ++counts.invalid;
    } else if (header.label) {
      labels.push_back(labelOf(values[header.columns[*header.label].first_value]));
    }
    if (points.size() < kBlockRows) continue;
    if (!visit(points, labels)) return counts;
    points.clear();
    labels.clear();
  }
  if (counts.points < header.points) throw countError(file, header, std::to_string(counts.points) + " whole ones");
  if (!points.empty()) visit(points, labels);
  return counts;
}

}  // namespace tank_datum
