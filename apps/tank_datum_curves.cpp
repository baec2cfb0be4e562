#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

#include "exit_status.h"
#include "fit/curve_comparison.h"
#include "parsed.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

struct CurvesCommand {
  std::string stations;               ///< stations.csv of tank_datum
  double from_deg = 0, to_deg = 360;  ///< the arc, as its azimuths count
  CurveOptions options;
};

bool parseCommandLine(int argc, char** argv, CurvesCommand& command, int& status) {
  CLI::App app(
      "The four curves of the paper through the same points of a datum - Lagrange, Bezier, least-squares polynomial "
      "and "
      "cubic B-spline - and how far the stations between these points lie from each.",
      "tank_datum_curves");
  app.option_defaults()->always_capture_default();
  app.add_option("stations", command.stations, "stations.csv of a datum")->required();
  app.add_option("--points", command.options.points, "stations that the curves are laid through, evenly chosen");
  app.add_option("--degree", command.options.degree, "of the least-squares polynomial");
  app.add_option("--from-deg", command.from_deg, "azimuth that the arc begins at");
  app.add_option("--to-deg", command.to_deg,
                 "azimuth that it ends at; at most a turn further, which is the whole ring");
  app.set_version_flag("--version", std::string("tank_datum_curves ") + kVersion);
  return parsed(app, argc, argv, status);
}

std::vector<std::string> cellsOf(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// A finite number, or unknown.
double numberOf(const std::string& cell, const std::string& path) {
  char* end = nullptr;
  const double value = cell.empty() ? std::nan("") : std::strtod(cell.c_str(), &end);
  if (cell.empty() || (end == cell.c_str() + cell.size() && std::isfinite(value))) return value;
  throw Error(Error::Kind::File, "stations", path, cell, "a number");
}

/// azimuth_deg and z of the stations whose z is known.
LinePoints readStations(const std::string& path) {
  std::ifstream in(path);
  std::string row;
  if (!std::getline(in, row)) throw Error(Error::Kind::File, "stations", path, "not read", "a stations.csv");
  const std::vector<std::string> names = cellsOf(row);
  const auto azimuth = static_cast<std::size_t>(std::find(names.begin(), names.end(), "azimuth_deg") - names.begin());
  const auto z = static_cast<std::size_t>(std::find(names.begin(), names.end(), "z") - names.begin());
  if (std::max(azimuth, z) >= names.size()) {
    throw Error(Error::Kind::File, "stations", "header of " + path, row.substr(0, 60), "columns azimuth_deg and z");
  }
  LinePoints stations;
  while (std::getline(in, row)) {
    const std::vector<std::string> cells = cellsOf(row);
    if (std::max(azimuth, z) >= cells.size()) throw Error(Error::Kind::File, "stations", path, row, "a whole row");
    const double known = numberOf(cells[z], path);
    if (std::isfinite(known)) stations.emplace_back(numberOf(cells[azimuth], path), known);
  }
  return stations;
}

/// The stations from one azimuth to another, in order; the first again at the end of a whole turn.
LinePoints arcOf(const LinePoints& stations, double from_deg, double to_deg) {
  LinePoints arc;
  for (const auto& station : stations) {
    const double first = from_deg + std::fmod(std::fmod(station.x() - from_deg, 360.0) + 360.0, 360.0);
    for (const double azimuth : {first, first + 360.0}) {
      if (azimuth <= to_deg) arc.emplace_back(azimuth, station.y());
    }
  }
  std::sort(arc.begin(), arc.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return arc;
}

void requireArc(const CurvesCommand& command) {
  const double length = command.to_deg - command.from_deg;
  if (length > 0.0 && length <= 360.0) return;
  std::ostringstream text;
  text << command.to_deg;
  throw Error(Error::Kind::Option, "options", "to-deg", text.str(), "more than from-deg, by a turn at most");
}

int run(const CurvesCommand& command) {
  requireArc(command);
  const LinePoints line = arcOf(readStations(command.stations), command.from_deg, command.to_deg);
  const auto curves = compareCurves(line, command.options);
  if (curves.empty()) {
    std::cerr << "tank_datum_curves: stations: known elevations of the arc, " << line.size() << ", expected more than "
              << command.options.points << "\n";
    return kNoDatum;
  }
  std::printf("%d points, %zu checks between them, azimuth %g to %g deg\n", command.options.points,
              line.size() - static_cast<std::size_t>(command.options.points), line.front().x(), line.back().x());
  std::printf("%-12s %10s %10s %13s\n", "curve", "rms_mm", "largest_mm", "overshoot_mm");
  for (const CurveFigures& c : curves) {
    std::printf("%-12s %10.3f %10.3f %13.3f\n", nameOf(c.kind), 1e3 * c.rms, 1e3 * c.largest, 1e3 * c.overshoot);
  }
  return kUsable;
}

}  // namespace
}  // namespace tank_datum

int main(int argc, char** argv) {
  using namespace tank_datum;
  CurvesCommand command;
  int status = kUsable;
  if (!parseCommandLine(argc, argv, command, status)) return status;
  try {
    return run(command);
  } catch (const Error& error) {
    std::cerr << "tank_datum_curves: " << error.what() << "\n";
    return error.kind() == Error::Kind::Option ? kWrongUse : kFileFailed;
  }
}
