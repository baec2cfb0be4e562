#include <charconv>
#include <cmath>

#include "io/csv.h"
#include "io/whole_file.h"
#include "setups/agreement.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

Error refusedRow(const std::string& path, const CsvRow& row, const std::string& value, const std::string& expected) {
  return {Error::Kind::File, "setups", {placeOf(path, row), value, expected, path}};
}

double coordinateOf(const std::string& cell, const std::string& path, const CsvRow& row) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (code == std::errc() && end == cell.data() + cell.size() && std::isfinite(value)) return value;
  throw refusedRow(path, row, "\"" + cell + "\"", "a coordinate");
}

bool isHeading(const CsvRow& row) { return row.cells.size() > 1 && row.cells[1] == "x"; }

}  // namespace

std::map<std::string, Eigen::Vector3d> readSetupOrigins(const std::string& path, double metres_per_unit) {
  std::map<std::string, Eigen::Vector3d> origins;
  for (const CsvRow& row : csvRows(wholeFile(path, "setups"))) {
    if (origins.empty() && isHeading(row)) continue;
    if (row.cells.size() != 4) {
      throw refusedRow(path, row, std::to_string(row.cells.size()) + " cells", "name,x,y,z");
    }
    Eigen::Vector3d at;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = coordinateOf(row.cells[static_cast<std::size_t>(axis) + 1], path, row);
    }
    if (!origins.emplace(row.cells[0], at * metres_per_unit).second) {
      throw refusedRow(path, row, "\"" + row.cells[0] + "\" again", "each name once");
    }
  }
  return origins;
}

}  // namespace tank_datum
