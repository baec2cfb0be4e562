#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "exit_status.h"
#include "fit/curve_comparison.h"
#include "io/csv_table.h"
#include "parsed.h"
#include "run_main.h"
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

/// azimuth_deg and z of the stations whose z is known.
LinePoints readStations(const std::string& path) {
  const CsvTable table(path, "stations");
  LinePoints stations;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double z = table.number(row, "z");
    if (std::isfinite(z)) stations.emplace_back(table.number(row, "azimuth_deg"), z);
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
  return runMain("tank_datum_curves", [&] {
    CurvesCommand command;
    int status = kUsable;
    return parseCommandLine(argc, argv, command, status) ? run(command) : status;
  });
}
