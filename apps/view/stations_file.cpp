#include "view/stations_file.h"

#include <charconv>
#include <fstream>
#include <map>
#include <sstream>

#include "core/units.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::view {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// One row by the names of the header.
class Row {
 public:
  Row(const std::vector<std::string>& names, const std::vector<std::string>& cells, std::string where)
      : where_(std::move(where)) {
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) cells_[names[i]] = cells[i];
  }

  const std::string& text(const std::string& name) const {
    const auto cell = cells_.find(name);
    if (cell == cells_.end()) throw Error(Error::Kind::File, "view", where_, "no " + name, "a stations.csv");
    return cell->second;
  }

  /// NaN of an empty cell.
  double number(const std::string& name) const {
    const std::string& cell = text(name);
    if (cell.empty()) return kUnknown;
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) {
      throw Error(Error::Kind::File, "view", name + " in " + where_, cell, "a number");
    }
    return value;
  }

 private:
  std::map<std::string, std::string> cells_;
  std::string where_;
};

Station stationOf(const Row& row, const Eigen::Vector3d& origin) {
  Station s;
  s.azimuth = row.number("azimuth_deg") * kDegree;
  s.x = row.number("x") - origin.x();
  s.y = row.number("y") - origin.y();
  s.z = row.number("z") - origin.z();
  s.sigma_z = row.number("sigma_z");
  s.radius = row.number("radius");
  s.sigma_radius = row.number("sigma_radius");
  s.z_paper = row.number("z_paper") - origin.z();
  s.z_tilt = row.number("z_tilt") - origin.z();
  s.u = row.number("u");
  const std::string& flag = row.text("flag");
  if (flag == "measured") s.flag = StationFlag::Measured;
  if (flag == "interpolated") s.flag = StationFlag::Interpolated;
  return s;
}

}  // namespace

std::vector<Station> readStations(const std::string& path, const Eigen::Vector3d& origin) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line)) {
    throw Error(Error::Kind::File, "view", path, "not readable", "the stations.csv beside datum.json");
  }
  const auto names = cellsOf(line);
  std::vector<Station> stations;
  while (std::getline(in, line)) {
    const std::string where = "row " + std::to_string(stations.size() + 1) + " of " + path;
    stations.push_back(stationOf(Row(names, cellsOf(line), where), origin));
  }
  return stations;
}

}  // namespace tank_datum::view
