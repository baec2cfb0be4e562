#pragma once

#include <string>
#include <vector>

namespace tank_datum {

/// A row of a table as text (RFC 4180), and the line it begins on.
struct CsvRow {
  std::size_t line = 0;
  std::vector<std::string> cells;
};

/// The rows of a text; a cell may stand in double quotes, blanks around it are dropped, empty lines and lines that
/// begin with # are passed over. A byte order mark and line ends of any kind are read.
/// @param separator  between cells
std::vector<CsvRow> csvRows(const std::string& text, char separator = ',');

/// "FILE line 12", for messages.
std::string placeOf(const std::string& file, const CsvRow& row);

}  // namespace tank_datum
