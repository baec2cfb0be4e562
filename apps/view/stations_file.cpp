#include "view/stations_file.h"

#include "core/units.h"
#include "io/csv_table.h"

namespace tank_datum::view {
namespace {

Station stationOf(const CsvTable& table, std::size_t row, const Eigen::Vector3d& origin) {
  Station s;
  s.azimuth = table.number(row, "azimuth_deg") * kDegree;
  s.x = table.number(row, "x") - origin.x();
  s.y = table.number(row, "y") - origin.y();
  s.z = table.number(row, "z") - origin.z();
  s.sigma_z = table.number(row, "sigma_z");
  s.radius = table.number(row, "radius");
  s.sigma_radius = table.number(row, "sigma_radius");
  s.z_paper = table.number(row, "z_paper") - origin.z();
  s.z_tilt = table.number(row, "z_tilt") - origin.z();
  s.u = table.number(row, "u");
  const std::string& flag = table.text(row, "flag");
  if (flag == "measured") s.flag = StationFlag::Measured;
  if (flag == "interpolated") s.flag = StationFlag::Interpolated;
  return s;
}

}  // namespace

std::vector<Station> readStations(const std::string& path, const Eigen::Vector3d& origin) {
  const CsvTable table(path, "view");
  std::vector<Station> stations;
  for (std::size_t row = 0; row < table.rows(); ++row) stations.push_back(stationOf(table, row, origin));
  return stations;
}

}  // namespace tank_datum::view
