#include "tank_datum/report/report.h"

#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "io/pcd_copy.h"
#include "io/pcd_writer.h"
#include "report/setups_json.h"
#include "report/shell_report.h"
#include "report/text_file.h"
#include "tank_datum/core/error.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

std::string text(double value) { return shortestText(value); }

std::string text(const std::optional<std::size_t>& count) { return count ? std::to_string(*count) : std::string(); }

/// x, y and z are 4-byte floats relative to a local origin, since PCL 1.13 reads 8-byte ones as zeros.
void writeCloud(const std::string& path, const Points& points, const Eigen::Vector3d& origin) {
  std::vector<PcdField> fields = {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}};
  for (const char* name : kFullNames) fields.push_back({name, 'F', 8});
  const Eigen::Vector3d from = localOrigin(origin);
  PcdHeading heading;
  Eigen::Vector3d::Map(heading.notes.origin.data()) = from;
  PcdWriter writer(path, fields, PcdWriter::Format::Binary, heading);
  std::vector<double> rows;
  rows.reserve(fields.size() * points.size());
  for (const auto& p : points) {
    const Eigen::Vector3d absolute = p + origin, local = absolute - from;
    rows.insert(rows.end(), local.data(), local.data() + 3);
    rows.insert(rows.end(), absolute.data(), absolute.data() + 3);
  }
  writer.append(rows);
  writer.commit();
}

}  // namespace

std::string stationsCsv(const Datum& datum) {
  std::string csv =
      "station,azimuth_deg,x,y,z,sigma_z,radius,sigma_radius,n_shell,n_foundation,flag,z_paper,z_tilt,u,u_fit,"
      "curvature,n_setups,sigma_setup,reason\n";
  const Eigen::Vector3d& o = datum.origin;
  for (std::size_t i = 0; i < datum.stations.size(); ++i) {
    const Station& s = datum.stations[i];
    const std::string cells[] = {text(toDegrees(s.azimuth)),
                                 text(s.x + o.x()),
                                 text(s.y + o.y()),
                                 text(s.z + o.z()),
                                 text(s.sigma_z),
                                 text(s.radius),
                                 text(s.sigma_radius),
                                 text(s.n_shell),
                                 text(s.n_foundation),
                                 nameOf(s.flag),
                                 text(s.z_paper + o.z()),
                                 text(s.z_tilt + o.z()),
                                 text(s.u),
                                 text(s.u_fit),
                                 text(s.curvature),
                                 text(s.n_setups),
                                 text(s.sigma_setup),
                                 nameOf(s.reason)};
    csv += std::to_string(i);
    for (const std::string& cell : cells) csv += "," + cell;
    csv += "\n";
  }
  return csv;
}

void writeResults(const std::string& folder, const Datum& datum, const Provenance& provenance) {
  writeTextFile(folder + "/datum.json", datumJson(datum, provenance));
  writeTextFile(folder + "/stations.csv", stationsCsv(datum));
  writeTextFile(folder + "/shell.csv", shellCsv(datum.shell));
  if (!datum.hasStations()) return;
  if (!datum.covariance.empty()) writeTextFile(folder + "/datum_nodes.csv", nodesCsv(datum));
  Points curve;
  for (const Station& s : datum.stations) {
    if (s.flag != StationFlag::Missing) curve.emplace_back(s.x, s.y, s.z);
  }
  if (!datum.levelled) writeCloud(folder + "/datum_points.pcd", datum.edge_points, datum.origin);
  writeCloud(folder + "/datum_curve.pcd", curve, datum.origin);
}

}  // namespace tank_datum
