#include "io/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/io_error.h"
#include "io/whole_file.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

CsvTable::CsvTable(const std::string& path, std::string stage)
    : path_(echoPath(path)), stage_(std::move(stage)), rows_(csvRows(wholeFile(path, stage_))) {
  if (rows_.empty()) throw Error(Error::Kind::File, stage_, path_, "empty", "a header line that names the columns");
  names_ = rows_.front().cells;
  rows_.erase(rows_.begin());
  for (CsvRow& row : rows_) {
    if (row.cells.size() > names_.size()) {
      throw Error(Error::Kind::File, stage_,
                  {placeOf(path_, row), std::to_string(row.cells.size()) + " cells",
                   std::to_string(names_.size()) + " as in the header line, numbers with decimal points", path_});
    }
    row.cells.resize(names_.size());
  }
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
  const auto name = std::find(names_.begin(), names_.end(), column);
  if (name == names_.end()) {
    throw Error(Error::Kind::File, stage_, {"header of " + path_, "no " + column, "a column of that name", path_});
  }
  return rows_[row].cells[static_cast<std::size_t>(name - names_.begin())];
}

double CsvTable::number(std::size_t row, const std::string& column) const {
  const std::string& cell = text(row, column);
  if (cell.empty()) return kUnknown;
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw Error(Error::Kind::File, stage_,
                {column + " in " + placeOf(path_, rows_[row]), echo(cell), "a number", path_});
  }
  return value;
}

}  // namespace tank_datum
