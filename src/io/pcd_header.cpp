#include "io/pcd_header.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/pcd_lines.h"
#include "io/pcd_size.h"
#include "io/setup_labels.h"
#include "io/words.h"

namespace tank_datum {
namespace {

constexpr std::uint64_t kLongestRow = 64 * 1024;  // bytes

void checkVersion(const PcdLines& lines) {
  if (!lines.has("VERSION")) return;
  std::string_view version = lines.word("VERSION");
  if (version.substr(0, 1) == "v") version.remove_prefix(1);
  if (version.substr(0, 1) == "0") version.remove_prefix(1);
  if (version != ".5" && version != ".6" && version != ".7") {
    throw fileError("VERSION", lines.path, echo(lines.word("VERSION")), "0.5, 0.6 or 0.7");
  }
}

std::int64_t parseCount(const PcdLines& lines, std::string_view text) {
  std::int64_t count = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (code != std::errc() || end != text.data() + text.size()) {
    throw fileError("COUNT", lines.path, echo(text), "whole numbers");
  }
  return count;
}

PcdColumn parseColumn(const PcdLines& lines, std::size_t i) {
  PcdColumn column;
  column.name = lines.list("FIELDS")[i];
  if (lines.has("COUNT")) column.count = parseCount(lines, lines.list("COUNT")[i]);
  if (column.count == 0) return column;  // no bytes of any type
  const std::string type = inCase(lines.list("TYPE")[i], std::toupper);
  const std::string_view size = lines.list("SIZE")[i];
  const bool is_float = type == "F" && (size == "4" || size == "8");
  const bool is_integer = (type == "I" || type == "U") && (size == "1" || size == "2" || size == "4" || size == "8");
  if (!is_float && !is_integer) {
    throw fileError("TYPE and SIZE of field " + echo(column.name), lines.path, echo(type) + " " + echo(size),
                    "F of 4 or 8 bytes, I or U of 1, 2, 4 or 8");
  }
  column.type = type[0];
  column.size = size[0] - '0';
  return column;
}

/// Puts a column behind the others. A negative COUNT leads back, and 0 nowhere; neither is a field. PCL's writer means
/// by it that a message's fields do not stand in the order of their names.
void addColumn(PcdColumn column, const PcdLines& lines, PcdHeader& header) {
  const auto before = static_cast<std::int64_t>(header.row_bytes), size = static_cast<std::int64_t>(column.size);
  const auto longest = static_cast<std::int64_t>(kLongestRow);
  if (column.count > (longest - before) / size || column.count < -before / size) {
    throw fileError("COUNT of field " + echo(column.name), lines.path, std::to_string(column.count),
                    "rows of at most " + std::to_string(kLongestRow) + " bytes, and no fewer than none");
  }
  column.offset = header.row_bytes;
  column.first_value = header.row_values;
  header.row_bytes = static_cast<std::size_t>(before + column.count * size);
  if (column.count <= 0) return;
  header.row_values += static_cast<std::size_t>(column.count);
  header.columns.push_back(std::move(column));
}

void parseColumns(const PcdLines& lines, PcdHeader& header) {
  const std::size_t fields = lines.list("FIELDS").size();
  for (const std::string_view key : {"SIZE", "TYPE", "COUNT"}) {
    if (key == "COUNT" && !lines.has(key)) continue;
    if (lines.list(key).size() != fields) {
      throw fileError(std::string(key), lines.path, std::to_string(lines.list(key).size()) + " values",
                      std::to_string(fields) + " as in FIELDS");
    }
  }
  for (std::size_t i = 0; i < fields; ++i) addColumn(parseColumn(lines, i), lines, header);
  for (const PcdColumn& column : header.columns) {
    if (column.offset + static_cast<std::size_t>(column.count * column.size) <= header.row_bytes) continue;
    throw fileError("COUNT", lines.path, "a row that ends before its field " + echo(column.name), "rows of all fields");
  }
}

/// The column of that name, which must be the only one and hold one value a row; nothing when there is none.
std::optional<std::size_t> findColumn(const PcdHeader& header, const std::string& name, const std::string& path) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < header.columns.size(); ++i) {
    if (header.columns[i].name != name) continue;
    if (found) throw fileError("FIELDS", path, name + " twice", "it once");
    found = i;
  }
  if (found && header.columns[*found].count != 1) {
    throw fileError("COUNT of field " + name, path, std::to_string(header.columns[*found].count), "1");
  }
  return found;
}

/// Moves on to the coordinates of the scan's own frame where they stand beside those that are relative to an origin.
void preferFull(const PcdLines& lines, PcdHeader& header) {
  std::array<std::size_t, 3> full{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto column = findColumn(header, kFullNames[axis], lines.path);
    if (!column) return;
    full[axis] = *column;
  }
  header.xyz = full;
  header.notes.origin = {};
}

void findXyz(const PcdLines& lines, PcdHeader& header) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto column = findColumn(header, std::string(1, "xyz"[axis]), lines.path);
    if (!column) column = findColumn(header, std::string(1, "XYZ"[axis]), lines.path);
    if (!column) throw fileError("FIELDS", lines.path, std::string("no ") + "xyz"[axis], "x, y and z");
    header.xyz[axis] = *column;
  }
  preferFull(lines, header);
}

/// The first of the names that a field of one value a row has.
void findLabel(PcdHeader& header) {
  for (const char* name : kSetupLabels) {
    for (std::size_t i = 0; i < header.columns.size() && !header.label; ++i) {
      if (header.columns[i].name == name && header.columns[i].count == 1) header.label = i;
    }
  }
}

/// Where the scanner stood. Zeros are what writers put who do not know.
void parseViewpoint(const PcdLines& lines, PcdHeader& header) {
  if (!lines.has("VIEWPOINT") || lines.list("VIEWPOINT").size() < 3) return;
  std::array<double, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view text = lines.list("VIEWPOINT")[axis];
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), place[axis]);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(place[axis])) return;
  }
  if (place != std::array<double, 3>{}) header.viewpoint = place;
}

void parsePoints(const PcdLines& lines, PcdHeader& header) {
  const auto width = lines.number("WIDTH");
  const std::uint64_t height = lines.number("HEIGHT").value_or(1);
  const auto points = lines.number("POINTS");
  if (!width && !points) throw fileError("POINTS", lines.path, "missing", "a line POINTS or WIDTH");
  std::uint64_t product = points.value_or(0);
  if (width && (__builtin_mul_overflow(*width, height, &product) || (points && product != *points))) {
    throw fileError("WIDTH x HEIGHT", lines.path, std::to_string(*width) + " x " + std::to_string(height),
                    points ? std::to_string(*points) + " (POINTS)" : "a 64-bit number");
  }
  header.points = product;
}

void parseEncoding(const PcdLines& lines, PcdHeader& header) {
  const std::string word = inCase(lines.word("DATA"), std::tolower);
  if (word == "ascii") {
    header.encoding = PcdEncoding::Ascii;
  } else if (word == "binary") {
    header.encoding = PcdEncoding::Binary;
  } else if (word == "binary_compressed") {
    header.encoding = PcdEncoding::BinaryCompressed;
  } else {
    throw fileError("DATA", lines.path, echo(word), "ascii, binary or binary_compressed");
  }
}

}  // namespace

PcdHeader readPcdHeader(const InputFile& file) {
  const std::string text = file.head(kLongestPcdHeader);
  const PcdLines lines = splitPcdHeader(text, file);
  PcdHeader header;
  header.data_offset = lines.data_offset;
  checkVersion(lines);
  parseEncoding(lines, header);
  parseColumns(lines, header);
  header.notes = readPcdNotes(lines.comments, file.path());
  findXyz(lines, header);
  findLabel(header);
  parseViewpoint(lines, header);
  parsePoints(lines, header);
  checkPcdSize(file, header);
  return header;
}

PcdHeader readPcdHeader(const std::string& path) { return readPcdHeader(InputFile(path)); }

}  // namespace tank_datum
