#include "io/text_rows.h"

#include <algorithm>
#include <utility>

#include "io/block_source.h"
#include "io/coordinates.h"
#include "io/input_file.h"
#include "io/io_error.h"
#include "io/text_number.h"

namespace tank_datum {
namespace {

/// Blanks that do not part two columns.
const char* skipPadding(const char* at, const char* end, char separator) {
  while (at != end && isBlank(*at) && *at != separator) ++at;
  return at;
}

/// Behind a column that is not read; its text may be in quotes.
const char* skipColumn(const char* at, const char* end, char separator) {
  if (at != end && *at == '"') {
    at = std::find(at + 1, end, '"');
    if (at != end) ++at;
  }
  while (at != end && (separator == ' ' ? !isBlank(*at) : *at != separator)) ++at;
  return at;
}

/// Behind a number, in quotes or not; null when there is none.
const char* takeNumber(const char* at, const char* end, double& value) {
  const bool quoted = at != end && *at == '"';
  const char* stop = parseNumber(quoted ? at + 1 : at, end, value);
  if (stop == nullptr || !quoted) return stop;
  return stop != end && *stop == '"' ? stop + 1 : nullptr;
}

class TextSource : public BlockSource {
 public:
  TextSource(TextRows rows, double metres_per_unit) : rows_(std::move(rows)), metres_per_unit_(metres_per_unit) {
    for (const TextSection& section : rows_.sections) size_ += section.rows;
  }

  std::uint64_t size() const override { return size_; }

  double coordinateStep(const Eigen::Vector3d&) const override {
    return 0.0;
  }  // text has the digits it was written with

  std::string labelField() const override { return rows_.label_field; }

  std::optional<Eigen::Vector3d> viewpoint(std::uint32_t label) const override {
    if (rows_.columns.labelled() || label >= rows_.sections.size()) return std::nullopt;
    std::optional<Eigen::Vector3d> place = rows_.sections[label].viewpoint;
    if (place) *place *= metres_per_unit_;
    return place;
  }

 protected:
  std::uint64_t blockCount() const override { return rows_.lines.chunkCount(); }

  ScanCounts decode(const Eigen::Vector3d& origin, const BlockRows& chosen, BlockBuffer& buffer) const override {
    buffer.points.clear();
    buffer.labels.clear();
    const Frame frame{metres_per_unit_, origin};
    std::string_view text = rows_.lines.read(chosen.block, buffer.bytes);
    std::uint64_t line = rows_.lines.firstOf(chosen.block);
    const auto ends_behind = [](std::uint64_t at, const TextSection& s) { return at < s.first_line + s.rows; };
    auto section = std::upper_bound(rows_.sections.begin(), rows_.sections.end(), line, ends_behind);
    ScanCounts counts;
    std::size_t next = chosen.choice.first;
    for (; section != rows_.sections.end(); ++line) {
      const auto row = takeLine(text);
      if (!row) break;
      if (line < section->first_line) continue;
      const bool looked_at = counts.points == next;
      if (looked_at) next += chosen.choice.step;
      if (!addRow(*row, line, *section, looked_at, {frame, buffer})) ++counts.invalid;
      ++counts.points;
      while (section != rows_.sections.end() && line + 1 >= section->first_line + section->rows) ++section;
    }
    return counts;
  }

 private:
  struct To {
    const Frame& frame;
    BlockBuffer& buffer;
  };

  /// Adds the point of a line if it is looked at; false when it is none.
  bool addRow(std::string_view row, std::uint64_t line, const TextSection& section, bool looked_at, To to) const {
    std::array<double, 4> values{};
    const char* failed = parseRow(row, rows_.columns, values);
    if (failed != nullptr) throw rowError(rows_.lines, line, row, failed);
    Eigen::Vector3d point(values[0], values[1], values[2]);
    if (section.pose) {
      if (point.isZero(0.0)) return false;
      point = section.pose->leftCols<3>() * point + section.pose->col(3);
    }
    if (!appendFinite(point, to.frame, to.buffer.points)) return false;
    if (!looked_at) {
      to.buffer.points.pop_back();
    } else if (!rows_.label_field.empty()) {
      to.buffer.labels.push_back(rows_.columns.labelled() ? labelOf(values[3]) : section.label);
    }
    return true;
  }

  TextRows rows_;
  double metres_per_unit_;
  std::uint64_t size_ = 0;
};

}  // namespace

bool TextColumns::labelled() const { return std::find(meaning.begin(), meaning.end(), kLabel) != meaning.end(); }

const char* parseRow(std::string_view line, const TextColumns& columns, std::array<double, 4>& values) {
  const char separator = columns.separator;
  const char* const end = line.data() + line.size();
  const char* at = skipPadding(line.data(), end, separator == ' ' ? '\0' : separator);
  for (std::size_t i = 0; i < columns.meaning.size(); ++i) {
    if (i > 0 && separator != ' ') {
      if (at == end) return at;
      at = skipPadding(at + 1, end, separator);
    }
    const int meaning = columns.meaning[i];
    const char* const begin = at;
    if (meaning == TextColumns::kPassedOver) {
      at = skipColumn(at, end, separator);
    } else {
      at = takeNumber(at, end, values[static_cast<std::size_t>(meaning)]);
      if (at == nullptr || (at != end && !isBlank(*at) && *at != separator)) return begin;
    }
    at = skipPadding(at, end, separator == ' ' ? '\0' : separator);
    if (separator != ' ' && at != end && *at != separator) return begin;
  }
  return nullptr;
}

Error rowError(const TextLines& lines, std::uint64_t line, std::string_view text, const char* at) {
  const std::string_view rest = text.substr(static_cast<std::size_t>(at - text.data()));
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r;", 1));
  double value = 0.0;
  const char* stop = word.empty() ? nullptr : parseNumber(word.data(), word.data() + word.size(), value);
  if (stop != nullptr && stop != word.data() + word.size() && *stop == ',') {
    return commaError(lines, line, word);
  }
  if (rest.empty()) return lines.error(line, "\"" + echo(text) + "\"", "more columns, up to x, y and z");
  return lines.error(line, "\"" + echo(word) + "\"", "a number");
}

Error commaError(const TextLines& lines, std::uint64_t line, std::string_view text) {
  return lines.error(line, "\"" + echo(text) + "\"", "numbers with decimal points, not commas");
}

std::shared_ptr<const Scan::Source> textSource(TextRows rows, double metres_per_unit) {
  return std::make_shared<TextSource>(std::move(rows), metres_per_unit);
}

}  // namespace tank_datum
