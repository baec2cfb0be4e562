#include "io/text_layout.h"

#include <string>
#include <utility>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/ptx_layout.h"
#include "io/text_format.h"
#include "io/text_number.h"
#include "io/words.h"

namespace tank_datum {
namespace {

constexpr std::size_t kHead = 64 * 1024;  // bytes in which comments may name columns

/// The columns that the last comment before the first line names that does, else the first three.
TextColumns columnsOfComments(std::string_view head) {
  TextColumns columns;
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    const std::string_view rest = head;
    std::string_view only = line;
    if (takeLine(only)) return columns;
    if (const auto named = columnsNamed(line, separatorOf(line))) columns = *named;
    head = rest.substr(std::min(rest.size(), line.size() + 1));
  }
  return columns;
}

/// The columns that a header line names, parted in the rows as a first row is.
std::optional<TextColumns> columnsOfHeader(std::string_view header, char separator) {
  auto columns = columnsNamed(header, separator);
  if (!columns) columns = columnsNamed(header, separatorOf(header));
  if (columns) columns->separator = separator;
  return columns;
}

void readPts(TextRows& text) {
  TextCursor cursor(text.lines);
  for (std::uint64_t line = 0; line < text.lines.count();) {
    cursor.seek(line);
    const auto count_line = cursor.next();
    const long long count = parseWhole(*count_line);  // the caller looked at the first, the loop below at the others
    const std::uint64_t most = text.lines.count() - line - 1;
    if (static_cast<std::uint64_t>(count) > most) {
      throw text.lines.error(line, std::to_string(count) + " points",
                             "at most " + std::to_string(most) + ", the lines that follow");
    }
    std::uint64_t end = line + 1 + static_cast<std::uint64_t>(count);
    cursor.seek(end);
    for (auto next = cursor.next(); next && parseWhole(*next) < 0; next = cursor.next()) ++end;
    const auto label = static_cast<std::uint32_t>(text.sections.size());
    if (end > line + 1) text.sections.push_back({line + 1, end - line - 1, label, {}, {}});
    line = end;
  }
  if (text.sections.size() > 1) text.label_field = "block";
}

void readColumns(TextRows& text, std::string_view first) {
  std::uint64_t header_lines = 0;
  if (!beginsWithXyz(first)) {
    const std::string header(first);
    TextCursor cursor(text.lines);
    cursor.seek(1);
    const auto row = cursor.next();
    if (hasDecimalCommas(header)) throw commaError(text.lines, 0, header);
    const auto named = columnsOfHeader(header, separatorOf(row ? *row : header));
    if (!named) throw text.lines.error(0, "\"" + echo(header) + "\"", kKnownFormats);
    text.columns = *named;
    header_lines = 1;
  }
  const std::uint64_t rows = text.lines.count() - header_lines;
  if (rows > 0) text.sections.push_back({header_lines, rows, 0, {}, {}});
}

/// Parts the columns as the first row does, and refuses what would be read as other numbers.
void settleSeparator(TextRows& text) {
  if (text.sections.empty()) return;
  TextCursor cursor(text.lines);
  const std::uint64_t line = text.sections.front().first_line;
  cursor.seek(line);
  const std::string row(cursor.next().value_or(std::string_view()));
  if (hasDecimalCommas(row)) throw commaError(text.lines, line, row);
  text.columns.separator = separatorOf(row);
}

}  // namespace

TextRows readTextLayout(std::shared_ptr<const InputFile> file) {
  const std::string head = file->head(kHead);
  const std::size_t offset = byteOrderMarkOf(head);
  TextRows text{file, TextLines(*file, offset), columnsOfComments(std::string_view(head).substr(offset)), {}, {}};
  TextCursor cursor(text.lines);
  const auto first_line = cursor.next();
  if (!first_line) throw fileError("header", file->path(), "no line but comments", kKnownFormats);
  const std::string first(*first_line);
  if (parseWhole(first) < 0) {
    readColumns(text, first);
  } else {
    const auto second = cursor.next();
    const bool is_ptx = second && parseWhole(*second) >= 0;
    is_ptx ? readPtx(text) : readPts(text);
  }
  settleSeparator(text);
  if (text.columns.labelled()) text.label_field = "setup";
  return text;
}

}  // namespace tank_datum
