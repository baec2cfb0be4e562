#include "tank_datum/report.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "shell_report.h"
#include "sparkline.h"
#include "tank_datum/error.h"
#include "tank_datum/pcd_writer.h"
#include "tank_datum/statistics.h"
#include "units.h"

namespace tank_datum {
namespace {

/// The shortest text that reads back as the same double; empty when unknown.
std::string text(double value) {
  if (!std::isfinite(value)) return {};
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

std::string text(const std::optional<std::size_t>& count) { return count ? std::to_string(*count) : std::string(); }

void writeText(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out)
    throw Error(Error::Kind::File, "report", path, std::strerror(errno), "a writable folder with room for the results");
}

void writeCloud(const std::string& path, const Points& points, const Eigen::Vector3d& origin) {
  PcdWriter writer(path, {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}});
  std::vector<double> rows;
  rows.reserve(3 * points.size());
  for (const auto& p : points) {
    const Eigen::Vector3d absolute = p + origin;
    rows.insert(rows.end(), absolute.data(), absolute.data() + 3);
  }
  writer.append(rows);
  writer.commit();
}

constexpr std::size_t kSparklineColumns = 48;  ///< three bytes each, within the buffer of a line

double medianSigma(const std::vector<Station>& stations) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) sigmas.push_back(s.sigma_z);
  }
  return median(std::move(sigmas));
}

}  // namespace

const char* nameOf(StationFlag flag) {
  switch (flag) {
    case StationFlag::Measured:
      return "measured";
    case StationFlag::Interpolated:
      return "interpolated";
    case StationFlag::Missing:
      return "missing";
  }
  return "";
}

const char* nameOf(Status status) {
  switch (status) {
    case Status::NotRun:
      return "not_run";
    case Status::Ok:
      return "ok";
    case Status::Partial:
      return "partial";
    case Status::NoTank:
      return "no_tank";
    case Status::NoCrease:
      return "no_crease";
    case Status::TooFewPoints:
      return "too_few_points";
    case Status::FitFailed:
      return "fit_failed";
  }
  return "";
}

std::string stationsCsv(const Datum& datum) {
  std::string csv =
      "station,azimuth_deg,x,y,z,sigma_z,radius,sigma_radius,n_shell,n_foundation,flag,z_paper,z_tilt,u,u_fit,"
      "curvature\n";
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
                                 "",
                                 ""};
    csv += std::to_string(i);
    for (const std::string& cell : cells) csv += "," + cell;
    csv += "\n";
  }
  return csv;
}

std::string summary(const Datum& datum, bool blocks) {
  std::string result;
  const auto line = [&result](const char* format, auto... values) {
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, format, values...);
    result += std::string(buffer) + "\n";
  };
  line("%-14s %s", "status", nameOf(datum.status));
  if (!datum.message.empty()) result += "               " + datum.message + "\n";
  if (!datum.usable()) return result;
  const Level& level = datum.level;
  const double z = datum.origin.z();
  line("%-14s radius %.3f m, centre %.3f, %.3f, shell seen over %.0f deg", "tank", datum.circle.radius,
       datum.circle.center.x() + datum.origin.x(), datum.circle.center.y() + datum.origin.y(),
       toDegrees(datum.tank.coverage));
  line("%-14s %zu measured, %zu interpolated, %zu missing", "stations", level.measured, level.interpolated,
       level.missing);
  line("%-14s mean %.4f m, lowest %.4f m at %.0f deg, highest %.4f m at %.0f deg", "datum", level.mean + z,
       level.min + z, toDegrees(level.min_azimuth), level.max + z, toDegrees(level.max_azimuth));
  line("%-14s %.1f mm", "range", 1e3 * level.range());
  if (blocks) {
    line("%-14s %s from station 0 round", "elevation", sparkline(datum.stations, kSparklineColumns).c_str());
  }
  if (datum.refined.valid()) {
    line("%-14s shell and %s intersected, standard error %.2f mm (median)", "method",
         nameOf(datum.refined.profile.surface), 1e3 * medianSigma(datum.stations));
  } else {
    line("%-14s the paper's curve through edge points: expect millimetres of bias", "method");
  }
  line("%-14s RMS %.1f mm, largest %.1f mm over %zu points not used in the fit (%td control points)", "paper's curve",
       1e3 * datum.curve.rms, 1e3 * datum.curve.max_residual, datum.curve.check_points,
       datum.curve.control_points.rows());
  if (datum.tilt.valid()) {
    line("%-14s %.1f arc-seconds towards %.0f deg", "tilt", toArcSeconds(std::atan(datum.tilt.slope())),
         toDegrees(datum.tilt.direction));
  }
  if (std::isfinite(datum.antipodal.max_h)) {
    line("%-14s h %.1f mm over D %.3f m: %.5f deg, %.1f arc-seconds, azimuth %.0f deg", "antipodal",
         1e3 * datum.antipodal.max_h, datum.antipodal.diameter, toDegrees(datum.antipodal.angle()),
         toArcSeconds(datum.antipodal.angle()), toDegrees(datum.antipodal.azimuth));
  }
  result += shellSummary(datum.shell);
  return result;
}

void writeResults(const std::string& folder, const Datum& datum, const Provenance& provenance) {
  writeText(folder + "/datum.json", datumJson(datum, provenance));
  writeText(folder + "/stations.csv", stationsCsv(datum));
  writeText(folder + "/shell.csv", shellCsv(datum.shell));
  if (!datum.usable()) return;
  Points curve;
  for (const Station& s : datum.stations) {
    if (s.flag != StationFlag::Missing) curve.emplace_back(s.x, s.y, s.z);
  }
  writeCloud(folder + "/datum_points.pcd", datum.edge_points, datum.origin);
  writeCloud(folder + "/datum_curve.pcd", curve, datum.origin);
}

}  // namespace tank_datum
