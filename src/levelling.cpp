#include "levelling.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/azimuth.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "datum_stages.h"
#include "datum_status.h"
#include "io/csv.h"
#include "io/whole_file.h"
#include "limits/survey_spacing.h"
#include "shape/analysis.h"
#include "shape/deformation.h"
#include "shape/out_of_plane.h"
#include "stations/stations.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestStations = 4;   // stations, for a plane and something left over
constexpr std::size_t kMostStations = 3600;  // stations, ten a degree; the work grows with their square
constexpr double kLargestDiameter = 1000.0;  // no tank has half of it [m]
/// Elevations over the diameter: ten times the tilt that any code allows. Beyond it they are in another unit [m/m].
constexpr double kSteepest = 0.1;
constexpr double kNarrowest = 15.0 * kDegree;  // the arc that all stations lie in, as of a scan's [rad]

Error refused(const std::string& what, const std::string& value, const std::string& expected) {
  return Error(Error::Kind::Option, "levelling", what, value, expected);
}

struct Columns {
  std::size_t azimuth, elevation, sigma, count;
};

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
  return line.size() > 60 ? line.substr(0, 60) + "..." : line;
}

Columns columnsOf(const CsvRow& header, const std::string& file) {
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(header.cells.begin(), header.cells.end(), name) - header.cells.begin());
  };
  const Columns columns{column("azimuth_deg"), column("elevation"), column("sigma"), header.cells.size()};
  if (columns.azimuth == columns.count || columns.elevation == columns.count) {
    throw refused(placeOf(file, header), "\"" + joined(header.cells) + "\"",
                  "the header azimuth_deg,elevation or azimuth_deg,elevation,sigma");
  }
  return columns;
}

double numberIn(const CsvRow& row, std::size_t column, const char* name, const std::string& file) {
  const std::string& text = row.cells[column];
  double value = 0.0;
  const char *first = text.data() + (text.rfind('+', 0) == 0 ? 1 : 0), *last = text.data() + text.size();
  const auto read = std::from_chars(first, last, value);
  if (read.ec != std::errc() || read.ptr != last || !std::isfinite(value)) {
    throw refused(placeOf(file, row) + " " + name, "\"" + text + "\"", "a number");
  }
  return value;
}

void place(Station& s, double azimuth, double radius, const StationOptions& options) {
  s.azimuth = azimuth;
  s.direction = directionOf(azimuth, options);
  s.x = radius * portable::cos(s.direction);
  s.y = radius * portable::sin(s.direction);
}

Station stationFrom(const CsvRow& row, const Columns& columns, const std::string& file, double metres_per_unit) {
  if (row.cells.size() != columns.count) {
    throw refused(
        placeOf(file, row), std::to_string(row.cells.size()) + " cells",
        std::to_string(columns.count) + " as in the header line, parted by commas, numbers with decimal points");
  }
  Station s;
  s.azimuth = numberIn(row, columns.azimuth, "azimuth_deg", file) * kPi / 180.0;
  if (std::abs(s.azimuth) > kTwoPi + 1e-9) {
    throw refused(placeOf(file, row) + " azimuth_deg", row.cells[columns.azimuth], "degrees, -360 to 360");
  }
  s.azimuth = withinTurn(s.azimuth);
  if (row.cells[columns.elevation].empty()) return s;
  s.flag = StationFlag::Measured;
  s.z = numberIn(row, columns.elevation, "elevation", file) * metres_per_unit;
  if (columns.sigma == columns.count || row.cells[columns.sigma].empty()) return s;
  s.sigma_z = numberIn(row, columns.sigma, "sigma", file) * metres_per_unit;
  if (!(s.sigma_z > 0.0)) throw refused(placeOf(file, row) + " sigma", row.cells[columns.sigma], "> 0, or nothing");
  return s;
}

}  // namespace

std::vector<Station> levellingStations(const std::string& text, const std::string& file, double metres_per_unit,
                                       double diameter, const StationOptions& options) {
  const std::vector<CsvRow> rows = csvRows(text);
  if (rows.empty()) throw refused(file, "no lines", "the header line azimuth_deg,elevation and a row per station");
  const Columns columns = columnsOf(rows.front(), file);
  if (rows.size() - 1 > kMostStations) {
    throw refused(file, std::to_string(rows.size() - 1) + " rows", "at most " + std::to_string(kMostStations));
  }
  std::vector<Station> stations;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    stations.push_back(stationFrom(rows[i], columns, file, metres_per_unit));
    Station& s = stations.back();
    place(s, s.azimuth, 0.5 * diameter, options);
    if (s.flag == StationFlag::Measured) s.radius = 0.5 * diameter;
  }
  const auto before = [](const Station& a, const Station& b) { return a.azimuth < b.azimuth; };
  std::stable_sort(stations.begin(), stations.end(), before);
  constexpr double kSame = 1e-6;  // [rad]
  for (std::size_t i = 1; i < stations.size(); ++i) {
    if (stations[i].azimuth - stations[i - 1].azimuth < kSame) {
      throw refused(file, "two rows at " + fixedText(toDegrees(stations[i].azimuth)) + " degrees",
                    "one row per azimuth");
    }
  }
  return stations;
}

Datum datumOfLevelling(std::vector<Station> stations, double diameter, const DatumOptions& options) {
  if (!(diameter > 0.0 && diameter <= kLargestDiameter)) {
    throw refused("diameter", generalText(diameter),
                  "the tank's in metres, > 0 and <= " + generalText(kLargestDiameter));
  }
  requireValid(options);
  Datum datum;
  datum.levelled = true;
  datum.circle = datum.tank.circle = {{0.0, 0.0}, 0.5 * diameter};
  datum.stations = std::move(stations);
  datum.level = levelOf(datum.stations);
  if (datum.level.range() > kSteepest * diameter) {
    throw refused("elevations", fixedText(datum.level.range()) + " m apart",
                  "at most a tenth of the diameter; are they in option units, and the columns as the header says?");
  }
  if (datum.level.measured < kFewestStations) {
    datum.status = Status::TooFewPoints;
    datum.message = std::to_string(datum.level.measured) + " stations have an elevation, and a datum needs 4";
    datum.stations.clear();
    return datum;
  }
  if (const double span = kTwoPi - longestGap(datum.stations, 1.0); span < kNarrowest) {
    throw refused("azimuths", "all within " + fixedText(toDegrees(span), 1) + " degrees",
                  "stations round the tank, in degrees (radians need a factor of 57.2958)");
  }
  datum = finishDatum(std::move(datum), options);
  const double spacing = kTwoPi * datum.circle.radius / static_cast<double>(datum.stations.size());
  datum.analysis =
      analyse({datum.stations, datum.tilt, datum.circle.radius, {}, datum.covariance, widestLevelledGap(spacing)},
              options.analysis);
  datum.stations = withParts(std::move(datum.stations), datum.analysis.out_of_plane.stations);
  for (const std::string& warning : warningsOf(datum)) datum.analysis.notes.push_back("Warning: " + warning);
  return datum;
}

Datum readLevelling(const std::string& path, double metres_per_unit, double diameter, const DatumOptions& options) {
  return datumOfLevelling(
      levellingStations(wholeFile(path, "levelling"), path, metres_per_unit, diameter, options.stations), diameter,
      options);
}

}  // namespace tank_datum
