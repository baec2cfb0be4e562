#pragma once

#include <string>
#include <vector>

#include "io/csv.h"

namespace tank_datum {

/// A table whose first row names its columns, such as stations.csv; columns that nobody asks for may be there.
class CsvTable {
 public:
  /// @param stage  of the messages when it is refused
  /// @throws Error (File) when it cannot be read or has no header
  CsvTable(const std::string& path, std::string stage);

  std::size_t rows() const { return rows_.size(); }

  /// A cell; an empty one where the column is there and the row is short at its end.
  /// @throws Error (File) when there is no such column
  const std::string& text(std::size_t row, const std::string& column) const;

  /// A number; NaN of an empty cell.
  /// @throws Error (File) when there is no such column, or the cell is no finite number
  double number(std::size_t row, const std::string& column) const;

 private:
  std::string path_, stage_;
  std::vector<std::string> names_;
  std::vector<CsvRow> rows_;
};

}  // namespace tank_datum
