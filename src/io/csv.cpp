#include "io/csv.h"

#include <algorithm>

#include "io/words.h"

namespace tank_datum {
namespace {

std::string trimmed(const std::string& cell) {
  const auto first = cell.find_first_not_of(" \t");
  return first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
}

/// The text without a byte order mark and with \n alone for line ends.
std::string plainLines(std::string text) {
  text.erase(0, byteOrderMarkOf(text));
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    result += text[i] == '\r' ? '\n' : text[i];
  }
  return result + "\n";
}

/// Reads one cell from `at`, which is left on the separator or line end behind it.
std::string readCell(const std::string& text, std::size_t& at, char separator, std::size_t& line) {
  std::string cell;
  while (text[at] == ' ' || text[at] == '\t') ++at;
  if (text[at] != '"') {
    while (text[at] != separator && text[at] != '\n') cell += text[at++];
    return trimmed(cell);
  }
  for (++at; at < text.size(); ++at) {
    if (text[at] == '"' && text[at + 1] != '"') break;
    if (text[at] == '"') ++at;
    if (text[at] == '\n') ++line;
    cell += text[at];
  }
  while (at < text.size() - 1 && text[at] != separator && text[at] != '\n') ++at;
  at = std::min(at, text.size() - 1);
  return cell;
}

}  // namespace

std::vector<CsvRow> csvRows(const std::string& given, char separator) {
  const std::string text = plainLines(given);
  std::vector<CsvRow> rows;
  std::size_t line = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    CsvRow row{line++, {}};
    const bool comment = text[at] == '#';
    for (;; ++at) {
      row.cells.push_back(readCell(text, at, separator, line));
      if (text[at] == '\n') break;
    }
    if (!comment && (row.cells.size() > 1 || !row.cells.front().empty())) rows.push_back(row);
  }
  return rows;
}

std::string placeOf(const std::string& file, const CsvRow& row) { return file + " line " + std::to_string(row.line); }

}  // namespace tank_datum
